package nephele.editor.action;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import nephele.editor.session.EditorSession;
import nephele.editor.text.EditorRefusal;
import nephele.editor.text.Words;
import nephele.engine.asset.FileName;
import nephele.engine.level.json.NumberText;
import nephele.engine.math.Vec3;

/**
 * One use of an action.
 *
 * @param arguments by name; empty if a menu or a key asked for it
 * @param ui what needs a user or a window: file names, pictures
 */
public record ActionCall(EditorSession session, UserInterface ui, Map<String, String> arguments) {
    private static final Words MISSING =
            Words.of("%s is missing: write %s=…", "falta %s: escreva %s=…", "falta %s: escreve %s=…");
    private static final Words NO_VECTOR = Words.of(
            "%s must be three numbers x,y,z, not '%s'",
            "%s deve ter três números x,y,z, não '%s'", "%s deve ter três números x,y,z, não '%s'");
    private static final Words NO_FLAG = Words.of(
            "%s must be true or false, not '%s'",
            "%s deve ser true ou false, não '%s'", "%s deve ser true ou false, não '%s'");
    private static final Words NO_FILE = Words.of(
            "'%s' is no file name in this locale: choose another, or start Nephele with LC_ALL=C.UTF-8",
            "'%s' não é um nome de arquivo neste locale: escolha outro, ou inicie o Nephele com LC_ALL=C.UTF-8",
            "'%s' não é um nome de ficheiro neste locale: escolhe outro, ou inicia o Nephele com LC_ALL=C.UTF-8");
    private static final String FILE = "file";
    private static final Words NO_NUMBER = Words.of(
            "%s must be a number from %s to %s, not '%s'",
            "%s deve ser um número de %s a %s, não '%s'", "%s deve ser um número de %s a %s, não '%s'");
    private static final Words NO_WHOLE_NUMBER = Words.of(
            "%s must be a whole number from %s to %s, not '%s'",
            "%s deve ser um número inteiro de %s a %s, não '%s'", "%s deve ser um número inteiro de %s a %s, não '%s'");

    /** The greatest coordinate, distance or factor, as in a level. */
    static final double MOST = 1e7;

    /** Returns an argument as it was written; empty if it is not given. */
    public Optional<String> text(String name) {
        return Optional.ofNullable(arguments.get(name));
    }

    /** Returns an argument that a script must give. */
    public String needed(String name) throws EditorRefusal {
        String value = arguments.get(name);
        if (value == null) {
            throw new EditorRefusal(MISSING.with(name, name));
        }
        return value;
    }

    /** Returns a number of a range, or {@code absent} if the argument is not given. */
    public double number(String name, double least, double most, double absent) throws EditorRefusal {
        return arguments.containsKey(name) ? parsed(name, arguments.get(name), least, most) : absent;
    }

    /** Returns a whole number of a range, or {@code absent} if the argument is not given. */
    public int whole(String name, int least, int most, int absent) throws EditorRefusal {
        if (!arguments.containsKey(name)) {
            return absent;
        }
        double value = value(arguments.get(name));
        if (value >= least && value <= most && value == Math.rint(value)) {
            return (int) value;
        }
        throw new EditorRefusal(NO_WHOLE_NUMBER.with(name, least, most, arguments.get(name)));
    }

    /**
     * Returns true if an argument is given; else opens the part of the window that asks for it.
     *
     * @throws EditorRefusal in a script, which has nobody to ask
     */
    boolean isGiven(String name, String part) throws EditorRefusal {
        if (arguments.containsKey(name)) {
            return true;
        }
        if (!ui.hasUser()) {
            needed(name);
        }
        ui.show(part);
        return false;
    }

    /**
     * Returns the file that is given or that the user chooses; empty if the user cancels.
     *
     * @throws EditorRefusal if it is no name of a file, and in a script that gives none
     */
    Optional<Path> file(Supplier<Optional<Path>> chooser) throws EditorRefusal {
        if (ui.hasUser() && !arguments.containsKey(FILE)) {
            return chooser.get();
        }
        String typed = needed(FILE);
        if (FileName.objection(typed) != null) {
            throw new EditorRefusal(NO_FILE.with(FileName.printable(typed)));
        }
        return Optional.of(Path.of(typed));
    }

    /** Returns true or false as it is written, or {@code absent} if the argument is not given. */
    public boolean flag(String name, boolean absent) throws EditorRefusal {
        String typed = arguments.getOrDefault(name, String.valueOf(absent));
        if (!typed.equals("true") && !typed.equals("false")) {
            throw new EditorRefusal(NO_FLAG.with(name, typed));
        }
        return typed.equals("true");
    }

    /** Returns a vector that a script must give as {@code x,y,z}. */
    public Vec3 vector(String name) throws EditorRefusal {
        String[] parts = needed(name).split(",", -1);
        if (parts.length != 3) {
            throw new EditorRefusal(NO_VECTOR.with(name, needed(name)));
        }
        return new Vec3(
                parsed(name, parts[0], -MOST, MOST),
                parsed(name, parts[1], -MOST, MOST),
                parsed(name, parts[2], -MOST, MOST));
    }

    /** Returns a vector, or {@code absent} if the argument is not given. */
    public Vec3 vector(String name, Vec3 absent) throws EditorRefusal {
        return arguments.containsKey(name) ? vector(name) : absent;
    }

    /** Returns the words of an argument that are separated by commas. */
    public List<String> words(String name) throws EditorRefusal {
        return Arrays.stream(needed(name).split(",")).map(String::trim).toList();
    }

    private static double parsed(String name, String text, double least, double most) throws EditorRefusal {
        double value = value(text);
        if (value >= least && value <= most) {
            return value;
        }
        throw new EditorRefusal(NO_NUMBER.with(name, NumberText.of(least), NumberText.of(most), text));
    }

    /** Returns the value of a number; NaN if a text is none. */
    private static double value(String text) {
        try {
            return Double.parseDouble(text.trim());
        } catch (NumberFormatException noNumber) {
            return Double.NaN;
        }
    }
}
