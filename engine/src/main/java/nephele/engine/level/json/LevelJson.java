package nephele.engine.level.json;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.List;
import nephele.engine.level.Level;

/** Converts level files of version 1 to records and back. */
public final class LevelJson {
    private static final int VERSION = 1;
    private static final RecordFile<Level> FILE = RecordFile.of("level", VERSION, Level.class);
    private static final RecordFormat LEVEL = FILE.format();

    private LevelJson() {}

    /**
     * Reads strictly: unknown or duplicate keys, wrong types and numbers out of range are errors. Rules that need more
     * than one value are in {@link nephele.engine.rule.LevelRules}.
     *
     * @param file the file's name in messages
     * @throws LevelFormatException with all problems
     */
    public static Level read(String file, byte[] utf8) throws LevelFormatException {
        Problems problems = new Problems();
        JsonValue root = JsonTree.read(utf8, problems);
        if (root == null) {
            throw LevelFormatException.damage(file, problems.found());
        }
        Level level = null;
        if (root instanceof JsonValue.Members members) {
            if (FILE.hasHeader(members, problems)) {
                requireNoEntities(members, problems);
                level = (Level) LEVEL.read(members, problems);
                if (level == null) {
                    new WrittenMaterials(members, problems).reportUnknown();
                }
            }
        } else {
            ValueFormat.mismatch("an object, a level", root, problems);
        }
        problems.throwIfAny(file);
        return level;
    }

    /** Returns the canonical text: fixed key order, defaults omitted, numbers as in {@link NumberText}. */
    public static String write(Level level) {
        return FILE.write(level);
    }

    /** Returns a record of a level as canonical text on one line, such as a cloud to paste into a file. */
    public static String line(Record part) {
        return JsonText.line(RecordFormat.of(part.getClass()).write(part));
    }

    /**
     * Returns the SHA-256 of the canonical text in UTF-8, as 64 hexadecimal digits. What is neither drawn nor simulated
     * (par, landmark, hints, the editor's notes) does not change it: what was recorded in a level plays on as before.
     */
    public static String sha256(Level level) {
        try {
            byte[] text = write(level.withoutRemarks()).getBytes(StandardCharsets.UTF_8);
            return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(text));
        } catch (NoSuchAlgorithmException impossible) {
            throw new IllegalStateException("every Java has SHA-256", impossible);
        }
    }

    /** Returns the JSON Schema of what {@link #read} accepts, as far as a schema can express it. */
    public static String schema() {
        SchemaDefinitions definitions = new SchemaDefinitions();
        JsonValue.Members level = LEVEL.schemaBeside(definitions);
        JsonValue.Members properties = FILE.headerSchema();
        JsonValue.Members own = (JsonValue.Members) level.ask("properties");
        for (int i = 0; i < own.size(); i++) {
            properties.with(own.name(i), own.value(i));
        }
        properties.with(
                "entities",
                new JsonValue.Members()
                        .with("type", new JsonValue.Text("array"))
                        .with("maxItems", new JsonValue.Number(0)));
        return JsonText.of(new JsonValue.Members()
                .with("$schema", new JsonValue.Text("https://json-schema.org/draft/2020-12/schema"))
                .with("title", new JsonValue.Text("Nephele level, version " + VERSION))
                .with("type", new JsonValue.Text("object"))
                .with("properties", properties)
                .with("required", SchemaDefinitions.texts(List.of("format", "version")))
                .with("unevaluatedProperties", JsonValue.Literal.FALSE)
                .with("$defs", definitions.toJson()));
    }

    private static void requireNoEntities(JsonValue.Members members, Problems problems) {
        JsonValue entities = members.ask("entities");
        if (entities == null) {
            return;
        }
        int mark = problems.enter("entities");
        if (!(entities instanceof JsonValue.Array array)) {
            ValueFormat.mismatch("an array", entities, problems);
        } else if (!array.values().isEmpty()) {
            problems.error("this version knows no entities: leave the array empty");
        }
        problems.leave(mark);
    }
}
