package nephele.editor.action;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import nephele.editor.session.EditorSession;
import nephele.editor.text.Words;
import nephele.engine.math.Vec3;

/**
 * One use of an action.
 *
 * @param arguments by name; empty if a menu or a key asked for it
 * @param desk what needs a user or a window: file names, pictures
 */
public record ActionCall(EditorSession session, Desk desk, Map<String, String> arguments) {
    private static final Words MISSING =
            Words.of("%s is missing: write %s=…", "falta %s: escreva %s=…", "falta %s: escreve %s=…");
    private static final Words NO_VECTOR = Words.of(
            "%s must be three numbers x,y,z, not '%s'",
            "%s deve ter três números x,y,z, não '%s'", "%s deve ter três números x,y,z, não '%s'");
    private static final Words NO_NUMBER = Words.of(
            "%s must be a number, not '%s'", "%s deve ser um número, não '%s'", "%s deve ser um número, não '%s'");

    /** Returns an argument as it was written; empty if it is not given. */
    public Optional<String> text(String name) {
        return Optional.ofNullable(arguments.get(name));
    }

    /** Returns an argument that a script must give. */
    public String needed(String name) throws ActionFailure {
        String value = arguments.get(name);
        if (value == null) {
            throw new ActionFailure(MISSING.with(name, name));
        }
        return value;
    }

    /** Returns a number, or {@code absent} if the argument is not given. */
    public double number(String name, double absent) throws ActionFailure {
        return arguments.containsKey(name) ? parsed(name, arguments.get(name)) : absent;
    }

    /** Returns a vector that a script must give as {@code x,y,z}. */
    public Vec3 vector(String name) throws ActionFailure {
        String[] parts = needed(name).split(",", -1);
        if (parts.length != 3) {
            throw new ActionFailure(NO_VECTOR.with(name, needed(name)));
        }
        return new Vec3(parsed(name, parts[0]), parsed(name, parts[1]), parsed(name, parts[2]));
    }

    /** Returns a vector, or {@code absent} if the argument is not given. */
    public Vec3 vector(String name, Vec3 absent) throws ActionFailure {
        return arguments.containsKey(name) ? vector(name) : absent;
    }

    /** Returns the words of an argument that are separated by commas. */
    public List<String> words(String name) throws ActionFailure {
        return Arrays.stream(needed(name).split(",")).map(String::trim).toList();
    }

    private static double parsed(String name, String text) throws ActionFailure {
        try {
            double value = Double.parseDouble(text.trim());
            if (Double.isFinite(value)) {
                return value;
            }
        } catch (NumberFormatException noNumber) {
            // Told below, as infinity is.
        }
        throw new ActionFailure(NO_NUMBER.with(name, text));
    }
}
