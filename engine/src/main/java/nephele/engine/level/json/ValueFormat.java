package nephele.engine.level.json;

/** How one kind of value is read, written and described. */
interface ValueFormat {
    /** The value, or {@code null} after reporting to {@code problems} what is wrong. */
    Object read(JsonValue json, Problems problems);

    JsonValue write(Object value);

    /** JSON Schema (2020-12) of the value. */
    JsonValue.Members schema(SchemaDefinitions definitions);

    /** The value of an absent key when nothing else is said: {@code null}, or empty, or zero. */
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
