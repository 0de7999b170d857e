package nephele.engine.xmlscene;

import java.util.ArrayList;
import java.util.List;

/**
 * Splits a text into tags. It tolerates values without quotes, text and stray signs if the rest stays readable. It
 * supports no document types and expands only the five entities of XML and character numbers.
 */
final class XmlTags {
    /** Start and end tags together. */
    private static final int MOST_TAGS = 500_000;

    private static final int MOST_ATTRIBUTES = 100;
    private static final int MOST_NAME_LETTERS = 64;

    private final String text;
    private final SceneWarnings warnings;
    private final List<String> unquoted = new ArrayList<>();
    private int tags;
    private int inThisTag;
    private int at;
    private int counted;
    private int line = 1;

    XmlTags(String text, SceneWarnings warnings) {
        this.text = text;
        this.warnings = warnings;
    }

    /** Returns {@code null} after the last one. */
    XmlTag next() {
        while (true) {
            skipText();
            if (at >= text.length()) {
                return null;
            }
            if (text.startsWith("<!--", at)) {
                skipPast("-->", 4, "a comment");
            } else if (text.startsWith("<![CDATA[", at)) {
                warnings.warn(lineHere(), "text means nothing here: skipped");
                skipPast("]]>", 9, "a text section");
            } else if (text.startsWith("<?", at)) {
                skipPast("?>", 2, "an instruction");
            } else if (text.startsWith("<!", at)) {
                throw warnings.error(lineHere(), "document types and entities are not read", "delete <!…>");
            } else {
                int nameAt = text.startsWith("</", at) ? at + 2 : at + 1;
                if (isNameStart(nameAt)) {
                    countTag();
                    return tag(nameAt);
                }
                warnings.warn(lineHere(), "'<' without a name: skipped");
                at++;
            }
        }
    }

    private void countTag() {
        if (++tags > MOST_TAGS) {
            throw warnings.error(lineHere(), "more than " + MOST_TAGS + " tags", "split the scene");
        }
    }

    /** Returns the line at which the search for the next tag began. */
    int lineHere() {
        for (; counted < at; counted++) {
            if (text.charAt(counted) == '\n') {
                line++;
            }
        }
        return line;
    }

    private void skipText() {
        int tag = text.indexOf('<', at);
        int end = tag < 0 ? text.length() : tag;
        int start = at;
        while (start < end && text.charAt(start) <= ' ') {
            start++;
        }
        if (start < end) {
            at = start;
            warnings.warn(
                    lineHere(),
                    () -> "text means nothing here: " + SceneWarnings.quoted(text.substring(at, Math.min(end, at + 50)))
                            + " is skipped");
        }
        at = end;
    }

    private void skipPast(String end, int opening, String what) {
        int found = text.indexOf(end, at + opening);
        if (found < 0) {
            throw warnings.error(lineHere(), what + " begins here and never ends", "end it with " + end);
        }
        at = found + end.length();
    }

    private XmlTag tag(int nameAt) {
        int tagLine = lineHere();
        boolean closing = nameAt == at + 2;
        at = nameAt;
        String name = name();
        List<XmlAttribute> attributes = new ArrayList<>(4);
        unquoted.clear();
        inThisTag = 0;
        while (true) {
            skipBlanks();
            if (at >= text.length()) {
                throw warnings.error(tagLine, "the file ends inside <" + name, "restore its end");
            }
            char c = text.charAt(at);
            if (c == '>' || text.startsWith("/>", at) || c == '<') {
                return ended(c, closing, name, tagLine, List.copyOf(attributes));
            } else if (isNameStart(at)) {
                attribute(name, attributes);
            } else {
                warnings.warn(
                        lineHere(),
                        () -> "stray " + SceneWarnings.quoted(String.valueOf(c)) + " in <" + name + ">: skipped");
                at++;
            }
        }
    }

    private XmlTag ended(char sign, boolean closing, String name, int tagLine, List<XmlAttribute> attributes) {
        if (sign == '<') {
            warnings.warn(tagLine, () -> "<" + name + " has no '>'");
        }
        if (!unquoted.isEmpty()) {
            warnings.warn(tagLine, () -> "<" + name + "> has values without quotes: " + String.join(", ", unquoted));
        }
        at += sign == '<' ? 0 : sign == '>' ? 1 : 2;
        XmlTag.Kind open = sign == '/' ? XmlTag.Kind.EMPTY : XmlTag.Kind.OPEN;
        return new XmlTag(closing ? XmlTag.Kind.CLOSE : open, name, tagLine, attributes);
    }

    private void attribute(String tag, List<XmlAttribute> attributes) {
        int attributeLine = lineHere();
        if (++inThisTag > MOST_ATTRIBUTES) {
            throw warnings.error(
                    attributeLine, "<" + tag + "> has more than " + MOST_ATTRIBUTES + " values", "delete some");
        }
        String name = name();
        skipBlanks();
        if (at >= text.length() || text.charAt(at) != '=') {
            warnings.warn(attributeLine, () -> "'" + name + "' in <" + tag + "> has no value: skipped");
            return;
        }
        at++;
        skipBlanks();
        String value = value(name);
        if (holds(attributes, name)) {
            warnings.warn(attributeLine, () -> "'" + name + "' is there twice in <" + tag + ">: the first counts");
        } else {
            attributes.add(new XmlAttribute(name, value, attributeLine));
        }
    }

    private static boolean holds(List<XmlAttribute> attributes, String name) {
        return attributes.stream().anyMatch(attribute -> attribute.name().equalsIgnoreCase(name));
    }

    private String value(String name) {
        char quote = at < text.length() ? text.charAt(at) : ' ';
        if (quote == '"' || quote == '\'') {
            at++;
            int end = at;
            while (end < text.length() && text.charAt(end) != quote && text.charAt(end) != '<') {
                end++;
            }
            if (end < text.length() && text.charAt(end) == quote) {
                String quoted = text.substring(at, end);
                at = end + 1;
                return XmlEntities.expanded(quoted, lineHere(), warnings);
            }
        }
        unquoted.add(name);
        int start = at;
        while (at < text.length() && !endsValue()) {
            at++;
        }
        return XmlEntities.expanded(text.substring(start, at), lineHere(), warnings);
    }

    private boolean endsValue() {
        char c = text.charAt(at);
        return c <= ' ' || c == '>' || c == '<' || text.startsWith("/>", at);
    }

    private String name() {
        int start = at;
        while (at < text.length() && isNamePart(text.charAt(at))) {
            at++;
        }
        return text.substring(start, Math.min(at, start + MOST_NAME_LETTERS));
    }

    private boolean isNameStart(int position) {
        return position < text.length() && isNameStart(text.charAt(position));
    }

    private static boolean isNameStart(char c) {
        return c >= 'a' && c <= 'z' || c >= 'A' && c <= 'Z' || c == '_' || c >= 0x80 && Character.isLetter(c);
    }

    private static boolean isNamePart(char c) {
        return isNameStart(c) || c >= '0' && c <= '9' || c == '-' || c == '.' || c == ':';
    }

    private void skipBlanks() {
        while (at < text.length() && text.charAt(at) <= ' ') {
            at++;
        }
    }
}
