package nephele.engine.level.json;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import nephele.engine.asset.AssetId;
import nephele.engine.level.BoxFace;
import nephele.engine.level.TextKind;

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

    /** The format of text, by its kind. */
    record TextFormat(TextKind kind, String fallback) implements ValueFormat {
        /** Letters without a glyph (Hangul fillers) and the empty Braille pattern. */
        private static final String BLANK_LETTERS = "\u115f\u1160\u3164\uffa0\u2800";

        @Override
        public Object read(JsonValue json, Problems problems) {
            if (!(json instanceof JsonValue.Text text)) {
                return ValueFormat.mismatch("a text", json, problems);
            }
            String objection = objection(text.value());
            return objection == null ? text.value() : problems.error(objection);
        }

        private String objection(String text) {
            if (text.length() < kind.shortest() || text.length() > kind.longest()) {
                return "a text of " + kind.shortest() + " to " + kind.longest() + " characters is wanted, this one has "
                        + text.length();
            }
            if (kind == TextKind.ASSET) {
                return AssetId.rejectionReason(text);
            }
            if (kind == TextKind.SHA256) {
                return text.matches("[0-9a-fA-F]*") ? null : "64 hexadecimal digits are wanted";
            }
            for (int i = 0; i < text.length(); i++) {
                char c = text.charAt(i);
                if (kind == TextKind.ID && isInvisible(c)) {
                    return String.format(
                            Locale.ROOT,
                            "an id holds no invisible characters, this one has U+%04X at position %d",
                            (int) c,
                            i);
                }
                if (Character.isISOControl(c) && !(kind == TextKind.PROSE && (c == '\n' || c == '\t'))) {
                    return "the text holds a control character at position " + i;
                }
            }
            return kind == TextKind.ID && isBlank(text) ? "an id needs a character that can be seen" : null;
        }

        @Override
        public JsonValue write(Object value) {
            return new JsonValue.Text((String) value);
        }

        @Override
        public JsonValue.Members schema(SchemaDefinitions definitions) {
            var schema = new JsonValue.Members()
                    .with("type", new JsonValue.Text("string"))
                    .with("minLength", new JsonValue.Number(kind.shortest()))
                    .with("maxLength", new JsonValue.Number(kind.longest()));
            return switch (kind) {
                case ASSET -> schema.with("pattern", new JsonValue.Text("^[A-Za-z0-9._][A-Za-z0-9._/-]*$"));
                case ID -> schema.with("pattern", new JsonValue.Text("\\S"));
                case SHA256 -> schema.with("pattern", new JsonValue.Text("^[0-9a-fA-F]{64}$"));
                case NAME, PROSE -> schema;
            };
        }

        @Override
        public Object absent() {
            return fallback;
        }

        /**
         * Returns true for control and format characters, among them those that change the direction of writing, and line
         * ends.
         */
        private static boolean isInvisible(char c) {
            int type = Character.getType(c);
            return type == Character.CONTROL
                    || type == Character.FORMAT
                    || type == Character.LINE_SEPARATOR
                    || type == Character.PARAGRAPH_SEPARATOR;
        }

        /** Returns true if the text has no visible character. */
        private static boolean isBlank(String text) {
            return text.chars()
                    .allMatch(c -> Character.isWhitespace(c)
                            || Character.isSpaceChar(c)
                            || isInvisible((char) c)
                            || BLANK_LETTERS.indexOf(c) >= 0);
        }
    }
}
