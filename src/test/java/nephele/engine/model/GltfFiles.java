package nephele.engine.model;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Base64;

/** A glTF file of one triangle, as a template for tests. */
public final class GltfFiles {
    /** Positions (36 bytes), normals (36), texture coordinates (24), 3 indices of 2 bytes and 2 bytes of padding. */
    static final int BUFFER_BYTES = 104;

    /** Placeholders in the JSON: URI, the node's transform, and places for further members. */
    static final String JSON =
            """
            {
              "asset": { "version": "2.0" },
              "scene": 0,
              "scenes": [{ "nodes": [0] }],
              "nodes": [{ "mesh": 0FRAME }],
              "meshes": [{ "primitives": [{
                "attributes": { "POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2 }, "indices": 3 }] }],
              "accessors": [
                { "bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3" },
                { "bufferView": 0, "byteOffset": 36, "componentType": 5126, "count": 3, "type": "VEC3" },
                { "bufferView": 0, "byteOffset": 72, "componentType": 5126, "count": 3, "type": "VEC2" },
                { "bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR" }],
              "bufferViews": [
                { "buffer": 0, "byteLength": 96 },
                { "buffer": 0, "byteOffset": 96, "byteLength": 6 }],
              "buffers": [{ URI"byteLength": 104 }]
            }
            """;

    private GltfFiles() {}

    /** Returns the triangle (0, 0, 0), (1, 0, 0), (0, 1, 0), facing +z. */
    public static byte[] buffer() {
        ByteBuffer data = ByteBuffer.allocate(BUFFER_BYTES).order(ByteOrder.LITTLE_ENDIAN);
        for (float value : new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 1, 1, 1, 0, 0}) {
            data.putFloat(value);
        }
        return data.putShort((short) 0).putShort((short) 1).putShort((short) 2).array();
    }

    public static String json(String uri, String frame) {
        return JSON.replace("URI", uri.isEmpty() ? "" : "\"uri\": \"" + uri + "\", ")
                .replace("FRAME", frame);
    }

    public static String embedded(String frame) {
        String data = Base64.getEncoder().encodeToString(buffer());
        return json("data:application/octet-stream;base64," + data, frame);
    }

    public static byte[] binary(String json, byte[] buffer) {
        byte[] text = (json + " ".repeat(-json.length() & 3)).getBytes(StandardCharsets.UTF_8);
        var out = new ByteArrayOutputStream();
        int length = 12 + 8 + text.length + 8 + buffer.length;
        out.writeBytes(words(0x46546C67, 2, length, text.length, 0x4E4F534A));
        out.writeBytes(text);
        out.writeBytes(words(buffer.length, 0x004E4942));
        out.writeBytes(buffer);
        return out.toByteArray();
    }

    private static byte[] words(int... values) {
        ByteBuffer data = ByteBuffer.allocate(4 * values.length).order(ByteOrder.LITTLE_ENDIAN);
        for (int value : values) {
            data.putInt(value);
        }
        return data.array();
    }
}
