package nephele.engine.level.json;

import java.nio.charset.StandardCharsets;

/** Reads, writes and describes one kind of value. */
interface ValueFormat {
    /** Returns the value, or {@code null} after it has reported to {@code problems} what is wrong. */
    Object read(JsonValue json, Problems problems);

    JsonValue write(Object value);

    /** Returns the JSON Schema (2020-12) of the value. */
    JsonValue.Members schema(SchemaDefinitions definitions);

    /** Returns the value of an absent key without a stated default: {@code null}, empty or zero. */
    default Object absent() {
        return null;
    }

    /**
     * Returns the value of a JSON text.
     *
     * @param noun what the text is, in messages
     * @throws LevelFormatException if it is none of these values
     */
    default Object parsed(String json, String noun) {
        Problems problems = new Problems();
        JsonValue tree = JsonTree.read(json.getBytes(StandardCharsets.UTF_8), problems);
        Object value = tree == null ? null : read(tree, problems);
        problems.throwIfAny(noun + " " + json);
        return value;
    }

    /** Reports that {@code json} is not {@code wanted}. */
    static Object mismatch(String wanted, JsonValue json, Problems problems) {
        return problems.error(
                json == JsonValue.Literal.NULL
                        ? "null is not allowed: leave the key out or give " + wanted
                        : "this must be " + wanted + ", not " + json.kind());
    }
}
