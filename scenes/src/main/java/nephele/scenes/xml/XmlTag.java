package nephele.scenes.xml;

import java.util.List;

/** The content between {@code <} and {@code >}. */
record XmlTag(Kind kind, String name, int line, List<XmlAttribute> attributes) {
    enum Kind {
        OPEN,
        /** {@code <x/>} */
        EMPTY,
        CLOSE
    }
}
