package nephele.scenes.xml;

import java.util.ArrayList;
import java.util.List;

/** An element with its content. It grows while the file is read and is constant afterwards. */
final class XmlElement {
    private final Vocabulary.Word word;
    private final int line;
    private final List<XmlAttribute> attributes;
    private final List<XmlElement> children = new ArrayList<>(0);

    XmlElement(Vocabulary.Word word, XmlTag tag) {
        this.word = word;
        this.line = tag.line();
        this.attributes = tag.attributes();
    }

    void add(XmlElement child) {
        children.add(child);
    }

    Vocabulary.Word word() {
        return word;
    }

    /** Returns the name in the dialect's spelling. */
    String name() {
        return word.name();
    }

    boolean is(String name) {
        return word.name().equals(name);
    }

    int line() {
        return line;
    }

    List<XmlElement> children() {
        return children;
    }

    List<XmlElement> children(String name) {
        return children.stream().filter(child -> child.is(name)).toList();
    }

    /** Returns an attribute in any capitals. @return {@code null} if it is missing */
    XmlAttribute attribute(String name) {
        for (XmlAttribute attribute : attributes) {
            if (attribute.name().equalsIgnoreCase(name)) {
                return attribute;
            }
        }
        return null;
    }
}
