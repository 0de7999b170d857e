package nephele.engine.level.json;

/**
 * A kind of JSON file whose root is a record with {@link nephele.engine.level.Written} components; it is as strict as a
 * level.
 */
public final class RecordFile<T> {
    private final String noun;
    private final int version;
    private final Class<T> type;
    private final RecordFormat format;

    private RecordFile(String noun, int version, Class<T> type) {
        this.noun = noun;
        this.version = version;
        this.type = type;
        format = RecordFormat.of(type);
    }

    /**
     * Creates a kind of file.
     *
     * @param noun its name in messages; the format is named {@code nephele-noun}
     */
    public static <T extends Record> RecordFile<T> of(String noun, int version, Class<T> type) {
        return new RecordFile<>(noun, version, type);
    }

    /**
     * Reads a file.
     *
     * @param file its name in messages
     * @throws LevelFormatException with all problems
     */
    public T read(String file, byte[] utf8) throws LevelFormatException {
        Problems problems = new Problems();
        JsonValue root = JsonTree.read(utf8, problems);
        T value = null;
        if (root instanceof JsonValue.Members members) {
            if (hasHeader(members, problems)) {
                value = type.cast(format.read(members, problems));
            }
        } else if (root != null) {
            ValueFormat.mismatch("an object, a " + noun, root, problems);
        }
        problems.throwIfAny(file);
        return value;
    }

    /** Returns the canonical text: fixed key order, defaults omitted, numbers as in {@link NumberText}. */
    public String write(T value) {
        JsonValue.Members members = header();
        format.writeMembers(value, members);
        return JsonText.of(members);
    }

    RecordFormat format() {
        return format;
    }

    private String formatName() {
        return "nephele-" + noun;
    }

    /** Returns the first two keys, which every file has. */
    private JsonValue.Members header() {
        return new JsonValue.Members()
                .with("format", new JsonValue.Text(formatName()))
                .with("version", new JsonValue.Number(version));
    }

    /** Returns the schemas of the first two keys. */
    JsonValue.Members headerSchema() {
        return new JsonValue.Members()
                .with("format", new JsonValue.Members().with("const", new JsonValue.Text(formatName())))
                .with("version", new JsonValue.Members().with("const", new JsonValue.Number(version)));
    }

    /** Returns false after it has reported why the rest cannot be read. */
    boolean hasHeader(JsonValue.Members members, Problems problems) {
        int before = problems.count();
        if (!(members.ask("format") instanceof JsonValue.Text text)
                || !text.value().equals(formatName())) {
            report("format", "a " + noun + " file says \"format\": \"" + formatName() + "\"", problems);
        }
        JsonValue stated = members.ask("version");
        if (!(stated instanceof JsonValue.Number number) || number.value() != Math.rint(number.value())) {
            report("version", "a " + noun + " file says \"version\": " + version, problems);
        } else if (number.value() != version) {
            String which = number.value() > version ? "newer than this program reads" : "not one that ever existed";
            report("version", "version " + number.text() + " is " + which + " (" + version + ")", problems);
        }
        return problems.count() == before;
    }

    private static void report(String key, String message, Problems problems) {
        int mark = problems.enter(key);
        problems.error(message);
        problems.leave(mark);
    }
}
