package nephele.scenes.xml;

import java.util.Map;

/** Decodes the five entities of XML and character numbers; any other name stays as text. */
final class XmlEntities {
    private static final Map<String, String> PREDEFINED =
            Map.of("lt", "<", "gt", ">", "amp", "&", "quot", "\"", "apos", "'");
    private static final int LONGEST = 10;

    private XmlEntities() {}

    static String expanded(String value, int line, SceneWarnings warnings) {
        int ampersand = value.indexOf('&');
        if (ampersand < 0) {
            return value;
        }
        StringBuilder text = new StringBuilder(value.length());
        int done = 0;
        for (; ampersand >= 0; ampersand = value.indexOf('&', done)) {
            text.append(value, done, ampersand);
            int end = value.indexOf(';', ampersand);
            boolean complete = end > 0 && end - ampersand <= LONGEST;
            String meant = complete ? meant(value.substring(ampersand + 1, end)) : null;
            if (meant == null) {
                warnings.warn(line, "'&' begins no known entity: it is taken as it stands");
            }
            text.append(meant == null ? "&" : meant);
            done = meant == null ? ampersand + 1 : end + 1;
        }
        return text.append(value, done, value.length()).toString();
    }

    private static String meant(String name) {
        if (!name.startsWith("#")) {
            return PREDEFINED.get(name);
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
