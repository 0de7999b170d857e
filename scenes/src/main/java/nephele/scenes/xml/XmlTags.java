package nephele.scenes.xml;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/**
 * Splits a text into tags. It tolerates values without quotes, text and stray signs if the rest stays readable. It
 * supports no document types and expands only the five entities of XML and character numbers.
 */
final class XmlTags {
    private static final Map<String, String> ENTITIES =
            Map.of("lt", "<", "gt", ">", "amp", "&", "quot", "\"", "apos", "'");
    private static final int LONGEST_ENTITY = 10;

    /** Start and end tags together. */
    private static final int MOST_TAGS = 500_000;

    private static final int MOST_ATTRIBUTES = 100;
    private static final int MOST_NAME_LETTERS = 64;
    private static final int MOST_SHARED_LETTERS = 16;

    private final String text;
    /** The letters of the text; a file's length, which is limited, bounds their number. */
    private final char[] letters;

    /** Short strings by a hash; a later one takes the place of an earlier one. */
    private final String[] shared = new String[1024];

    private final SceneWarnings warnings;
    /** The attributes of the tag that is being read. */
    private final List<XmlAttribute> attributes = new ArrayList<>();

    private final List<String> unquoted = new ArrayList<>();
    private int tags;
    private int inThisTag;
    private int at;
    private int line = 1;
    private int lineEnd;

    XmlTags(String text, SceneWarnings warnings) {
        this.text = text;
        letters = text.toCharArray();
        this.warnings = warnings;
        lineEnd = endOfLine(0);
    }

    /** Returns {@code null} after the last one. */
    XmlTag next() {
        while (true) {
            skipText();
            if (at >= letters.length) {
                return null;
            }
            int nameAt = text.startsWith("</", at) ? at + 2 : at + 1;
            if (isNameStart(nameAt)) {
                countTag();
                return tag(nameAt);
            } else if (text.startsWith("<!--", at)) {
                skipPast("-->", 4, "a comment");
            } else if (text.startsWith("<![CDATA[", at)) {
                warnings.warn(lineHere(), "text means nothing here: skipped");
                skipPast("]]>", 9, "a text section");
            } else if (text.startsWith("<?", at)) {
                skipPast("?>", 2, "an instruction");
            } else if (text.startsWith("<!", at)) {
                throw warnings.error(lineHere(), "document types and entities are not read", "delete <!…>");
            } else {
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
        while (lineEnd < at) {
            line++;
            lineEnd = endOfLine(lineEnd + 1);
        }
        return line;
    }

    /** Returns the end of the line of a place; beyond the text for the last line. */
    private int endOfLine(int from) {
        int end = text.indexOf('\n', from);
        return end < 0 ? Integer.MAX_VALUE : end;
    }

    private void skipText() {
        int tag = text.indexOf('<', at);
        int end = tag < 0 ? letters.length : tag;
        int start = at;
        while (start < end && letters[start] <= ' ') {
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
        attributes.clear();
        unquoted.clear();
        inThisTag = 0;
        while (true) {
            skipBlanks();
            if (at >= letters.length) {
                throw warnings.error(tagLine, "the file ends inside <" + name, "restore its end");
            }
            char c = letters[at];
            if (c == '>' || c == '<' || c == '/' && text.startsWith("/>", at)) {
                return ended(c, closing, name, tagLine);
            } else if (isNameStart(at)) {
                attribute(name);
            } else {
                warnings.warn(
                        lineHere(),
                        () -> "stray " + SceneWarnings.quoted(String.valueOf(c)) + " in <" + name + ">: skipped");
                at++;
            }
        }
    }

    private XmlTag ended(char sign, boolean closing, String name, int tagLine) {
        if (sign == '<') {
            warnings.warn(tagLine, () -> "<" + name + " has no '>'");
        }
        if (!unquoted.isEmpty()) {
            warnings.warn(tagLine, () -> "<" + name + "> has values without quotes: " + String.join(", ", unquoted));
        }
        at += sign == '<' ? 0 : sign == '>' ? 1 : 2;
        XmlTag.Kind open = sign == '/' ? XmlTag.Kind.EMPTY : XmlTag.Kind.OPEN;
        return new XmlTag(closing ? XmlTag.Kind.CLOSE : open, name, tagLine, List.copyOf(attributes));
    }

    private void attribute(String tag) {
        int attributeLine = lineHere();
        if (++inThisTag > MOST_ATTRIBUTES) {
            throw warnings.error(
                    attributeLine, "<" + tag + "> has more than " + MOST_ATTRIBUTES + " values", "delete some");
        }
        String name = name();
        skipBlanks();
        if (at >= letters.length || letters[at] != '=') {
            warnings.warn(attributeLine, () -> "'" + name + "' in <" + tag + "> has no value: skipped");
            return;
        }
        at++;
        skipBlanks();
        String value = value(name);
        if (holds(name)) {
            warnings.warn(attributeLine, () -> "'" + name + "' is there twice in <" + tag + ">: the first counts");
        } else {
            attributes.add(new XmlAttribute(name, value, attributeLine));
        }
    }

    private boolean holds(String name) {
        // A stream for each of a million attributes would take a third of the time of the whole file.
        for (int i = 0; i < attributes.size(); i++) {
            if (attributes.get(i).name().equalsIgnoreCase(name)) {
                return true;
            }
        }
        return false;
    }

    private String value(String name) {
        char quote = at < letters.length ? letters[at] : ' ';
        if (quote == '"' || quote == '\'') {
            at++;
            int end = at;
            while (end < letters.length && letters[end] != quote && letters[end] != '<') {
                end++;
            }
            if (end < letters.length && letters[end] == quote) {
                String quoted = string(at, end);
                at = end + 1;
                return withoutEntities(quoted, lineHere(), warnings);
            }
        }
        unquoted.add(name);
        int start = at;
        while (at < letters.length && !endsValue()) {
            at++;
        }
        return withoutEntities(string(start, at), lineHere(), warnings);
    }

    private boolean endsValue() {
        char c = letters[at];
        return c <= ' ' || c == '>' || c == '<' || c == '/' && text.startsWith("/>", at);
    }

    private String name() {
        int start = at;
        while (at < letters.length && isNamePart(letters[at])) {
            at++;
        }
        return string(start, Math.min(at, start + MOST_NAME_LETTERS));
    }

    /** Returns a part of the text; most are short and have been there before, so that there is one of each in memory. */
    private String string(int from, int to) {
        if (to - from > MOST_SHARED_LETTERS) {
            return text.substring(from, to);
        }
        int hash = 0;
        for (int i = from; i < to; i++) {
            hash = 31 * hash + letters[i];
        }
        int place = (hash ^ hash >>> 8) & shared.length - 1;
        String known = shared[place];
        if (known == null || known.length() != to - from || !text.startsWith(known, from)) {
            known = text.substring(from, to);
            shared[place] = known;
        }
        return known;
    }

    private boolean isNameStart(int position) {
        return position < letters.length && isNameStart(letters[position]);
    }

    private static boolean isNameStart(char c) {
        return c >= 'a' && c <= 'z' || c >= 'A' && c <= 'Z' || c == '_' || c >= 0x80 && Character.isLetter(c);
    }

    private static boolean isNamePart(char c) {
        return isNameStart(c) || c >= '0' && c <= '9' || c == '-' || c == '.' || c == ':';
    }

    private void skipBlanks() {
        while (at < letters.length && letters[at] <= ' ') {
            at++;
        }
    }

    /** Decodes the five entities of XML and character numbers; any other name stays as text. */
    private static String withoutEntities(String value, int line, SceneWarnings warnings) {
        int ampersand = value.indexOf('&');
        if (ampersand < 0) {
            return value;
        }
        StringBuilder text = new StringBuilder(value.length());
        int done = 0;
        for (; ampersand >= 0; ampersand = value.indexOf('&', done)) {
            text.append(value, done, ampersand);
            int end = value.indexOf(';', ampersand);
            boolean complete = end > 0 && end - ampersand <= LONGEST_ENTITY;
            String meant = complete ? entity(value.substring(ampersand + 1, end)) : null;
            if (meant == null) {
                warnings.warn(line, "'&' begins no known entity: it is taken as it stands");
            }
            text.append(meant == null ? "&" : meant);
            done = meant == null ? ampersand + 1 : end + 1;
        }
        return text.append(value, done, value.length()).toString();
    }

    private static String entity(String name) {
        if (!name.startsWith("#")) {
            return ENTITIES.get(name);
        }
        boolean hexadecimal = name.startsWith("#x");
        try {
            int code = Integer.parseInt(name.substring(hexadecimal ? 2 : 1), hexadecimal ? 16 : 10);
            boolean sign = code >= ' ' && Character.isValidCodePoint(code) && (code < 0xd800 || code > 0xdfff);
            return sign ? Character.toString(code) : null;
        } catch (NumberFormatException noNumber) {
            return null;
        }
    }
}
