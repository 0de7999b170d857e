package nephele.engine.level.json;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Supplier;

/** The {@code $defs} of a schema: one per record. */
final class SchemaDefinitions {
    private final Map<String, JsonValue> definitions = new TreeMap<>();

    /** Returns a reference to {@code type}'s schema, which is created on first use. */
    JsonValue.Members reference(Class<?> type, Supplier<JsonValue.Members> schema) {
        Class<?> outer = type.getDeclaringClass();
        String name = outer == null ? type.getSimpleName() : outer.getSimpleName() + "." + type.getSimpleName();
        if (!definitions.containsKey(name)) {
            definitions.put(name, schema.get());
        }
        return new JsonValue.Members().with("$ref", new JsonValue.Text("#/$defs/" + name));
    }

    JsonValue.Members toJson() {
        var members = new JsonValue.Members();
        definitions.forEach(members::with);
        return members;
    }

    /** Returns the schema without permission for other keys. */
    static JsonValue.Members closed(JsonValue.Members schema) {
        return schema.with("unevaluatedProperties", JsonValue.Literal.FALSE);
    }

    static JsonValue texts(List<String> texts) {
        return new JsonValue.Array(
                texts.stream().<JsonValue>map(JsonValue.Text::new).toList());
    }
}
