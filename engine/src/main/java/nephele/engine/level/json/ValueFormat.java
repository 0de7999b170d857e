package nephele.engine.level.json;

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

    /** Reports that {@code json} is not {@code wanted}. */
    static Object mismatch(String wanted, JsonValue json, Problems problems) {
        return problems.error(
                json == JsonValue.Literal.NULL
                        ? "null is not allowed: leave the key out or give " + wanted
                        : "this must be " + wanted + ", not " + json.kind());
    }
}
