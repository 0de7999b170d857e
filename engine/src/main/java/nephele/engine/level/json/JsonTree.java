package nephele.engine.level.json;

import com.google.gson.Strictness;
import com.google.gson.stream.JsonReader;
import java.io.EOFException;
import java.io.IOException;
import java.io.StringReader;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import nephele.engine.asset.MessageText;
import nephele.engine.asset.TextFile;

/**
 * Parses UTF-8 bytes to a tree. It rejects duplicate keys, unpaired surrogates and endless documents,
 * which Gson's strict mode accepts.
 */
public final class JsonTree {
    static final int MAX_FILE_BYTES = 16 << 20;

    private static final int MAX_DEPTH = 32;
    private static final int MAX_VALUES = 1_000_000;
    private static final int MAX_SHARED_NAMES = 1_000;
    private static final int MOST_PRINTED = 60;

    /** Bound below which every whole number is a double. */
    private static final double EXACT_INTEGERS = 1L << 53;

    private final JsonReader reader;
    private final Problems problems;
    private final boolean isBlank;
    private final Map<String, String> names = new HashMap<>();
    private int values;
    private int depth;
    private boolean isAbandoned;

    private JsonTree(JsonReader reader, Problems problems, boolean isBlank) {
        this.isBlank = isBlank;
        this.reader = reader;
        this.problems = problems;
    }

    /** Returns the document, or {@code null} after it has reported the reason. */
    static JsonValue read(byte[] utf8, Problems problems) {
        if (utf8.length > MAX_FILE_BYTES) {
            problems.error("the file has more than 16 MiB: split the level");
            return null;
        }
        try {
            String text = TextFile.text(utf8);
            var reader = new JsonReader(new StringReader(text));
            reader.setStrictness(Strictness.STRICT);
            reader.setNestingLimit(MAX_DEPTH + 1);
            return new JsonTree(reader, problems, text.isBlank()).document();
        } catch (TextFile.NotUtf8 noText) {
            problems.error("the file can't be read: " + noText.getMessage());
        } catch (OutOfMemoryError tooLarge) {
            problems.error("the file does not fit into memory: split the level");
        }
        return null;
    }

    private JsonValue document() {
        try {
            JsonValue root = value();
            reader.peek();
            return root;
        } catch (EOFException end) {
            problems.error(isBlank ? "the file is empty" : "the file ends too early" + where());
        } catch (IOException | IllegalStateException syntax) {
            if (!isAbandoned) {
                problems.error(plain(syntax.getMessage()) + where());
            }
        }
        return null;
    }

    private JsonValue value() throws IOException {
        if (++values > MAX_VALUES) {
            throw abandon("the file holds more than " + MAX_VALUES + " values: split the level");
        }
        return switch (reader.peek()) {
            case BEGIN_OBJECT -> object();
            case BEGIN_ARRAY -> array();
            case NUMBER -> number(reader.nextString());
            case STRING -> text(reader.nextString());
            case BOOLEAN -> reader.nextBoolean() ? JsonValue.Literal.TRUE : JsonValue.Literal.FALSE;
            case NULL -> {
                reader.nextNull();
                yield JsonValue.Literal.NULL;
            }
            case END_ARRAY, END_OBJECT, END_DOCUMENT, NAME -> throw abandon("this is not valid JSON" + where());
        };
    }

    private JsonValue object() throws IOException {
        deeper();
        var members = new JsonValue.Members();
        reader.beginObject();
        while (reader.hasNext()) {
            String name = shared(reader.nextName());
            int mark = problems.enter(name);
            if (members.size() == JsonValue.Members.MOST) {
                throw abandon("more than " + JsonValue.Members.MOST + " keys in one object");
            }
            if (members.contains(name)) {
                problems.error("the key is there twice: delete one");
                value();
            } else {
                members.with(name, value());
            }
            problems.leave(mark);
        }
        reader.endObject();
        depth--;
        return members;
    }

    /** Returns one shared copy of a name; the same few names occur in every record. */
    private String shared(String name) {
        String known = names.get(name);
        if (known == null && names.size() < MAX_SHARED_NAMES) {
            names.put(name, name);
        }
        return known == null ? name : known;
    }

    private JsonValue array() throws IOException {
        deeper();
        List<JsonValue> elements = new ArrayList<>(4);
        reader.beginArray();
        while (reader.hasNext()) {
            int mark = problems.enter(elements.size());
            elements.add(value());
            problems.leave(mark);
        }
        reader.endArray();
        depth--;
        return new JsonValue.Array(elements);
    }

    private JsonValue number(String text) {
        double value = Double.parseDouble(text);
        if (Double.isInfinite(value)) {
            problems.error("the number " + shortened(text) + " is too large");
            value = 0;
        }
        return new JsonValue.Number(value, Math.abs(value) >= EXACT_INTEGERS ? shortened(text) : null);
    }

    private JsonValue text(String text) {
        for (int i = 0; i < text.length(); i++) {
            char c = text.charAt(i);
            boolean pair = Character.isHighSurrogate(c)
                    && i + 1 < text.length()
                    && Character.isLowSurrogate(text.charAt(i + 1));
            if (pair) {
                i++;
            } else if (Character.isSurrogate(c)) {
                problems.error("the text holds half of a surrogate pair at character " + i);
                break;
            }
        }
        return new JsonValue.Text(text);
    }

    private void deeper() {
        if (++depth > MAX_DEPTH) {
            throw abandon("nested deeper than " + MAX_DEPTH + " levels");
        }
    }

    /** Reports why the rest of the document cannot be read, and returns what stops parsing. */
    private IllegalStateException abandon(String message) {
        problems.error(message);
        isAbandoned = true;
        return new IllegalStateException(message);
    }

    /**
     * Returns line and column, which Gson states only in its description: {@code JsonReader at line 3 column 7 path
     * $.x}.
     */
    private String where() {
        String text = reader.toString();
        int line = text.indexOf(" at line ");
        int path = text.indexOf(" path ", Math.max(line, 0));
        return line < 0 || path < 0 ? "" : " (" + text.substring(line + 4, path).replace(" column", ", column") + ")";
    }

    /** Returns Gson's message without its advice to callers and without the place. */
    private static String plain(String message) {
        if (message == null || message.startsWith("Use JsonReader") || message.startsWith("Nesting")) {
            return "this is not valid JSON";
        }
        int at = message.indexOf(" at line ");
        int end = message.indexOf('\n');
        String first = message.substring(0, at >= 0 ? at : end >= 0 ? end : message.length());
        return "this is not valid JSON: " + shortened(first);
    }

    /** Returns a key in the form used in paths. */
    static String printable(String name) {
        String start = name.length() <= MOST_PRINTED ? name : name.substring(0, MOST_PRINTED) + "…";
        return MessageText.printable(start);
    }

    public static String shortened(String text) {
        return text.length() <= 40 ? text : text.substring(0, 40) + "…";
    }
}
