package nephele.scenes.xml;

import java.util.regex.Pattern;
import nephele.engine.asset.MessageText;
import nephele.engine.math.Vec3;

/** The values of one element; an unreadable value counts as missing. */
final class ElementValues {
    /** Greatest magnitude; products of a few larger ones would overflow the floats of drawing. */
    private static final double LARGEST = 1e9;

    private static final int LONGEST_NUMBER = 64;
    private static final Pattern NUMBER = Pattern.compile("[+-]?(\\d+\\.?\\d*|\\.\\d+)([eE][+-]?\\d+)?");

    private final XmlElement element;
    private final SceneWarnings warnings;

    ElementValues(XmlElement element, SceneWarnings warnings) {
        this.element = element;
        this.warnings = warnings;
    }

    boolean has(String name) {
        return element.attribute(name) != null;
    }

    boolean hasAny(String... names) {
        for (String name : names) {
            if (has(name)) {
                return true;
            }
        }
        return false;
    }

    /**
     * Returns a text.
     *
     * @return {@code null} if it is missing or empty
     */
    String text(String name) {
        XmlAttribute attribute = element.attribute(name);
        return attribute == null || attribute.value().isBlank()
                ? null
                : attribute.value().strip();
    }

    double number(String name, double absent) {
        XmlAttribute attribute = element.attribute(name);
        if (attribute == null) {
            return absent;
        }
        String text = attribute.value().strip();
        boolean number = text.length() <= LONGEST_NUMBER && NUMBER.matcher(text).matches();
        double value = number ? Double.parseDouble(text) : Double.NaN;
        if (!(Math.abs(value) <= LARGEST)) {
            String what = number ? " is beyond 1e9" : " is no number";
            warn(attribute, SceneWarnings.quoted(text) + what + ": taken as left out");
            return absent;
        }
        return value;
    }

    double number(String name, double absent, double least, double most) {
        double value = number(name, absent);
        double within = Math.min(most, Math.max(least, value));
        if (value != within) {
            String range = MessageText.number(least) + " to " + MessageText.number(most);
            warn(
                    element.attribute(name),
                    MessageText.number(value) + " is not within " + range + ": taken as " + MessageText.number(within));
        }
        return within;
    }

    /** Returns a vector; missing components are {@code absent}. */
    Vec3 vector(String x, String y, String z, double absent) {
        return new Vec3(number(x, absent), number(y, absent), number(z, absent));
    }

    boolean flag(String name) {
        XmlAttribute attribute = element.attribute(name);
        String text = attribute == null ? "false" : attribute.value().strip();
        boolean yes = text.equalsIgnoreCase("true") || text.equals("1");
        if (!yes && !text.equalsIgnoreCase("false") && !text.equals("0")) {
            warn(attribute, SceneWarnings.quoted(text) + " is neither true nor false: taken as false");
        }
        return yes;
    }

    private void warn(XmlAttribute attribute, String message) {
        warnings.warn(attribute.line(), "'" + attribute.name() + "' in <" + element.name() + ">: " + message);
    }

    /** Warns about the element as a whole. */
    void warn(String message) {
        warnings.warn(element.line(), "<" + element.name() + ">: " + message);
    }
}
