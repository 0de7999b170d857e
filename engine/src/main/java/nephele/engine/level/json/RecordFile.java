package nephele.engine.level.json;

/**
 * A kind of JSON file whose root is a record with {@link nephele.engine.level.Written} components; it is as strict as a
 * level.
 */
public final class RecordFile<T> {
    private final FileHeader header;
    private final Class<T> type;
    private final RecordFormat format;

    private RecordFile(FileHeader header, Class<T> type) {
        this.header = header;
        this.type = type;
        format = FormatBuilder.record(type);
    }

    /**
     * Creates a kind of file.
     *
     * @param noun its name in messages; the format is named {@code nephele-noun}
     */
    public static <T extends Record> RecordFile<T> of(String noun, int version, Class<T> type) {
        return new RecordFile<>(new FileHeader(noun, "nephele-" + noun, version), type);
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
            if (header.isThat(members, problems)) {
                value = type.cast(format.read(members, problems));
            }
        } else if (root != null) {
            ValueFormat.mismatch("an object, a " + header.noun(), root, problems);
        }
        problems.throwIfAny(file);
        return value;
    }

    /** Returns the canonical text: fixed key order, defaults omitted, numbers as in {@link NumberText}. */
    public String write(T value) {
        JsonValue.Members members = header.written();
        format.writeMembers(value, members);
        return JsonText.of(members);
    }
}
