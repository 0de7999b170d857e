package nephele.engine.asset;

import java.util.Locale;
import java.util.OptionalInt;
import java.util.Set;

/**
 * The grammar of asset ids: relative paths that name the same file on every system. Letters, digits and {@code . _ -
 * /}; no empty, {@code .} or {@code ..} segment, no segment that ends in a dot or starts with a hyphen, no Windows
 * device name.
 */
public final class AssetId {
    /** Maximum length of an id in characters. */
    public static final int MAX_CHARACTERS = 128;

    private static final Set<String> DEVICES = Set.of("con", "prn", "aux", "nul");
    private static final String REMEDY =
            "write a path relative to the level's folder or to assets/, of letters, digits, '.', '_', '-' and '/'";

    private AssetId() {}

    /** Returns the reason why {@code id} is not an asset id, or {@code null} if it is one. */
    public static String rejectionReason(String id) {
        if (id.isEmpty() || id.length() > MAX_CHARACTERS) {
            return "an asset id has 1 to " + MAX_CHARACTERS + " characters";
        }
        OptionalInt other = id.codePoints().filter(c -> !allowed(c)).findFirst();
        if (other.isPresent()) {
            return notAllowed(other.getAsInt());
        }
        for (String segment : id.split("/", -1)) {
            String objection = segmentObjection(segment);
            if (objection != null) {
                return objection;
            }
        }
        return null;
    }

    private static String notAllowed(int character) {
        String text = Character.toString(character);
        String quoted = MessageText.printable(text).equals(text) ? "'" + text + "' (U+%04X)" : "U+%04X";
        return String.format(
                Locale.ROOT, "character " + quoted.replace("%'", "%%'") + " is not allowed in an asset id", character);
    }

    /** Throws an {@link AssetException} unless {@code id} is an asset id. */
    public static void check(String id) {
        String objection = rejectionReason(id);
        if (objection != null) {
            throw new AssetException(printable(id), objection, REMEDY);
        }
    }

    private static boolean allowed(int c) {
        return c >= 'a' && c <= 'z'
                || c >= 'A' && c <= 'Z'
                || c >= '0' && c <= '9'
                || c == '.'
                || c == '_'
                || c == '-'
                || c == '/';
    }

    private static String segmentObjection(String segment) {
        if (segment.isEmpty()) {
            return "an asset id neither starts nor ends with '/' and has no '//'";
        }
        if (segment.endsWith(".")) {
            return "no part of an asset id is '.' or '..' or ends with a dot";
        }
        if (segment.startsWith("-")) {
            return "no part of an asset id starts with '-'";
        }
        int dot = segment.indexOf('.');
        String stem = (dot < 0 ? segment : segment.substring(0, dot)).toLowerCase(Locale.ROOT);
        boolean port = stem.length() == 4
                && (stem.startsWith("com") || stem.startsWith("lpt"))
                && Character.isDigit(stem.charAt(3));
        return DEVICES.contains(stem) || port ? "'" + stem + "' is a device name on Windows" : null;
    }

    /** Returns an id shortened and without control characters, for messages. */
    static String printable(String id) {
        String shortened = id.length() <= MAX_CHARACTERS ? id : id.substring(0, MAX_CHARACTERS) + "…";
        return MessageText.printable(shortened);
    }
}
