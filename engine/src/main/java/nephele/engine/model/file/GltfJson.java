package nephele.engine.model.file;

import com.google.gson.JsonElement;
import com.google.gson.JsonParseException;
import com.google.gson.JsonParser;
import com.google.gson.Strictness;
import com.google.gson.stream.JsonReader;
import com.google.gson.stream.JsonToken;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import nephele.engine.model.ModelFileException;

/** Parses the JSON of a glTF file after limiting the number of its values to bound the memory. */
final class GltfJson {
    private static final int MOST_VALUES = 200_000;
    private static final int DEEPEST = 64;
    private static final Pattern LINE = Pattern.compile("line (\\d+)");

    private final String file;
    private final byte[] json;

    GltfJson(String file, byte[] json) {
        this.file = file;
        this.json = json;
    }

    GltfValue read() {
        try {
            countValues();
            JsonElement root = JsonParser.parseReader(reader());
            return new GltfValue(file, "", root);
        } catch (IOException | JsonParseException | IllegalStateException | NumberFormatException problem) {
            throw new ModelFileException(
                    file, line(problem.getMessage()), "is no valid JSON", "export the mesh again", problem);
        }
    }

    private void countValues() throws IOException {
        try (JsonReader reader = reader()) {
            int values = 0;
            for (JsonToken token = reader.peek(); token != JsonToken.END_DOCUMENT; token = reader.peek()) {
                pass(reader, token);
                if (++values > MOST_VALUES) {
                    throw new ModelFileException(
                            file,
                            line(reader.toString()),
                            "holds more than " + MOST_VALUES + " JSON values",
                            "export fewer nodes, or a .glb");
                }
            }
        }
    }

    private static void pass(JsonReader reader, JsonToken token) throws IOException {
        switch (token) {
            case BEGIN_ARRAY -> reader.beginArray();
            case END_ARRAY -> reader.endArray();
            case BEGIN_OBJECT -> reader.beginObject();
            case END_OBJECT -> reader.endObject();
            default -> reader.skipValue();
        }
    }

    private JsonReader reader() {
        var reader = new JsonReader(new InputStreamReader(new ByteArrayInputStream(json), StandardCharsets.UTF_8));
        reader.setStrictness(Strictness.STRICT);
        reader.setNestingLimit(DEEPEST);
        return reader;
    }

    private static int line(String message) {
        Matcher matcher = LINE.matcher(message == null ? "" : message);
        return matcher.find() ? Integer.parseInt(matcher.group(1)) : 0;
    }
}
