package nephele.engine.level.json;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import nephele.engine.level.BoxFace;

/** Formats of true and false, and of enums, written as lower-case words. */
public final class WordFormats {
    private WordFormats() {}

    /** @param fallback {@code null} if an absent key means that the owner's value applies */
    record Truth(Boolean fallback) implements ValueFormat {
        @Override
        public Object read(JsonValue json, Problems problems) {
            if (json == JsonValue.Literal.TRUE || json == JsonValue.Literal.FALSE) {
                return json == JsonValue.Literal.TRUE;
            }
            return ValueFormat.mismatch("true or false", json, problems);
        }

        @Override
        public JsonValue write(Object value) {
            return (Boolean) value ? JsonValue.Literal.TRUE : JsonValue.Literal.FALSE;
        }

        @Override
        public JsonValue.Members schema(SchemaDefinitions definitions) {
            return new JsonValue.Members().with("type", new JsonValue.Text("boolean"));
        }

        @Override
        public Object absent() {
            return fallback;
        }
    }

    /** One of an enum's constants. */
    public record Choice(List<String> words, Object[] constants) implements ValueFormat {
        static Choice of(Class<?> type) {
            Object[] constants = type.getEnumConstants();
            List<String> words = new ArrayList<>();
            for (Object constant : constants) {
                words.add(word(constant));
            }
            return new Choice(List.copyOf(words), constants);
        }

        public static String word(Object constant) {
            return constant instanceof BoxFace face
                    ? face.text()
                    : ((Enum<?>) constant).name().toLowerCase(Locale.ROOT).replace('_', '-');
        }

        @Override
        public Object read(JsonValue json, Problems problems) {
            if (!(json instanceof JsonValue.Text text)) {
                return ValueFormat.mismatch("one of " + words, json, problems);
            }
            Object constant = constant(text.value());
            return constant != null
                    ? constant
                    : problems.error("must be one of " + words + ", not '" + JsonTree.shortened(text.value()) + "'");
        }

        /** Returns the constant of that name, or {@code null}. */
        Object constant(String word) {
            int index = words.indexOf(word);
            return index < 0 ? null : constants[index];
        }

        @Override
        public JsonValue write(Object value) {
            return new JsonValue.Text(word(value));
        }

        @Override
        public JsonValue.Members schema(SchemaDefinitions definitions) {
            return new JsonValue.Members().with("enum", SchemaDefinitions.texts(words));
        }
    }
}
