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
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import nephele.engine.model.Mesh;
import nephele.engine.model.MeshLimits;
import nephele.engine.model.ModelFileException;
import nephele.engine.model.ModelText;

/**
 * Reads glTF 2.0: the triangles of the shown scene. Every count is validated against limits and the bytes present before
 * anything of its size is made, so that no file can make it allocate too much, and no address is followed.
 */
final class GltfFile {
    /** Beginnings of the names of extensions that change no triangles: of materials, textures and lights. */
    private static final List<String> WITHOUT_EFFECT =
            List.of("KHR_materials_", "KHR_texture_", "EXT_texture_", "MSFT_texture_", "KHR_lights_", "EXT_lights_");

    private static final List<String> SERVED = List.of(GltfAccessors.QUANTIZATION);

    private static final int MOST_VALUES = 200_000;
    private static final int DEEPEST = 64;
    private static final Pattern LINE = Pattern.compile("line (\\d+)");
    private static final int MAGIC = 0x46546C67;
    private static final int JSON_CHUNK = 0x4E4F534A;
    private static final int BINARY_CHUNK = 0x004E4942;
    private static final int HEADER_BYTES = 12;
    private static final int CHUNK_HEADER_BYTES = 8;

    private final String file;
    private final byte[] json;

    /** The first buffer of a .glb; {@code null} if there is none. */
    private final byte[] binary;

    private final Function<String, byte[]> neighbour;

    /** @param neighbour returns the bytes of a file in the same folder, {@code null} if there is none */
    GltfFile(String file, byte[] bytes, Function<String, byte[]> neighbour) {
        this.file = file;
        this.neighbour = neighbour;
        if (bytes.length > MeshLimits.MAX_GLTF_BYTES) {
            throw new ModelFileException(
                    file, 0, "is larger than " + (MeshLimits.MAX_GLTF_BYTES >> 20) + " MiB", "make the mesh coarser");
        }
        ByteBuffer data = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
        boolean isContainer = bytes.length >= 4 && data.getInt(0) == MAGIC;
        if (isContainer) {
            checkHeader(data);
        }
        json = isContainer ? chunk(data, HEADER_BYTES, JSON_CHUNK) : bytes;
        int next = HEADER_BYTES + CHUNK_HEADER_BYTES + json.length;
        binary = isContainer && next < data.limit() ? chunk(data, next, BINARY_CHUNK) : null;
    }

    /** @param notes receives one warning if the mesh differs from what the file asks for */
    Mesh read(Consumer<String> notes) {
        GltfValue root = parsed();
        checkVersion(root);
        GltfScene scene = new GltfScene(root, new GltfAccessors(root, binary, neighbour));
        Mesh mesh = scene.mesh();
        if (!scene.skipped().isEmpty()) {
            notes.accept(file + ": its " + String.join(" and ", scene.skipped())
                    + " are not applied, the mesh is shown as it is stored; export it in the pose to be shown");
        }
        return mesh;
    }

    /** Parses JSON after its values have been counted, which bounds the memory. */
    private GltfValue parsed() {
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

    private static void checkVersion(GltfValue root) {
        GltfValue version = root.member("asset").member("version");
        if (!version.text("").startsWith("2.")) {
            throw version.error("is not 2.0", "export the mesh as glTF 2.0");
        }
        for (GltfValue extension : root.member("extensionsRequired").elements()) {
            String name = extension.text("");
            if (WITHOUT_EFFECT.stream().noneMatch(name::startsWith) && !SERVED.contains(name)) {
                throw extension.error(
                        "is " + ModelText.quoted(name) + ", which can't be read",
                        name.contains("compression") ? "export without compression" : "export without it");
            }
        }
    }

    private void checkHeader(ByteBuffer data) {
        if (data.limit() < HEADER_BYTES + CHUNK_HEADER_BYTES) {
            throw wrong(data.limit(), "the file ends within its header");
        }
        if (data.getInt(4) != 2) {
            throw wrong(4, "is version " + Integer.toUnsignedString(data.getInt(4)) + " of the container, not 2");
        }
        if (data.getInt(8) != data.limit()) {
            throw wrong(
                    8,
                    "says that it has " + Integer.toUnsignedString(data.getInt(8)) + " bytes, but has " + data.limit());
        }
    }

    private byte[] chunk(ByteBuffer data, int at, int kind) {
        if (at + CHUNK_HEADER_BYTES > data.limit()) {
            throw wrong(at, "the file ends within a chunk's header");
        }
        int length = data.getInt(at);
        int start = at + CHUNK_HEADER_BYTES;
        if (data.getInt(at + 4) != kind) {
            throw wrong(at + 4, "the chunk is not the one expected there");
        }
        if (length < 0 || length > data.limit() - start) {
            throw wrong(at, "a chunk of " + Integer.toUnsignedString(length) + " bytes goes beyond the file's end");
        }
        return Arrays.copyOfRange(data.array(), start, start + length);
    }

    private ModelFileException wrong(int at, String reason) {
        return new ModelFileException(file, 0, "byte " + at + ": " + reason, "export it again");
    }
}
