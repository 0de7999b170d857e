package nephele.engine.level.json;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;

/** Formats of lists, and of maps keyed by a face's name. */
final class CollectionFormats {
    private CollectionFormats() {}

    /** An array with a bound on its length. */
    record Entries(ValueFormat element, int most) implements ValueFormat {
        @Override
        public Object read(JsonValue json, Problems problems) {
            if (!(json instanceof JsonValue.Array array)) {
                return ValueFormat.mismatch("an array", json, problems);
            }
            if (array.values().size() > most) {
                return problems.error("at most " + most + " entries are read, these are "
                        + array.values().size());
            }
            List<Object> entries = new ArrayList<>(array.values().size());
            int before = problems.count();
            for (int i = 0; i < array.values().size(); i++) {
                int mark = problems.enter(i);
                entries.add(element.read(array.values().get(i), problems));
                problems.leave(mark);
            }
            return problems.count() > before ? null : Collections.unmodifiableList(entries);
        }

        @Override
        public JsonValue write(Object value) {
            List<JsonValue> values = new ArrayList<>();
            for (Object entry : (List<?>) value) {
                values.add(element.write(entry));
            }
            return new JsonValue.Array(values);
        }

        @Override
        public JsonValue.Members schema(SchemaDefinitions definitions) {
            return new JsonValue.Members()
                    .with("type", new JsonValue.Text("array"))
                    .with("items", element.schema(definitions))
                    .with("maxItems", new JsonValue.Number(most));
        }

        @Override
        public Object absent() {
            return List.of();
        }
    }

    /** An object whose keys are an enum's words, or free names when {@code keys} is {@code null}. */
    record Table(WordFormats.Choice keys, ValueFormat element) implements ValueFormat {
        @Override
        public Object read(JsonValue json, Problems problems) {
            if (!(json instanceof JsonValue.Members members)) {
                return ValueFormat.mismatch("an object", json, problems);
            }
            Map<Object, Object> table = new TreeMap<>();
            int before = problems.count();
            for (int i = 0; i < members.size(); i++) {
                int mark = problems.enter(members.name(i));
                Object key = keys == null ? members.name(i) : keys.constant(anyCase(members.name(i)));
                if (key == null) {
                    problems.error("unknown key; known here: " + keys.words());
                } else if (table.containsKey(key)) {
                    problems.error("is given twice: delete one");
                } else {
                    table.put(key, element.read(members.value(i), problems));
                }
                problems.leave(mark);
            }
            return problems.count() > before ? null : table.isEmpty() ? Map.of() : Collections.unmodifiableMap(table);
        }

        /** Tags of languages have no case (RFC 5646, section 2.1.1): {@code pt-BR} is {@code pt-br}. */
        private static String anyCase(String name) {
            return name.toLowerCase(Locale.ROOT);
        }

        @Override
        public JsonValue write(Object value) {
            var members = new JsonValue.Members();
            for (Map.Entry<?, ?> entry : new TreeMap<Object, Object>((Map<?, ?>) value).entrySet()) {
                String name = keys == null ? (String) entry.getKey() : WordFormats.Choice.word(entry.getKey());
                members.with(name, element.write(entry.getValue()));
            }
            return members;
        }

        @Override
        public JsonValue.Members schema(SchemaDefinitions definitions) {
            var schema = new JsonValue.Members()
                    .with("type", new JsonValue.Text("object"))
                    .with("additionalProperties", element.schema(definitions));
            return keys == null
                    ? schema
                    : schema.with(
                            "propertyNames",
                            new JsonValue.Members().with("enum", SchemaDefinitions.texts(keys.words())));
        }

        @Override
        public Object absent() {
            return Map.of();
        }
    }
}
