package nephele.engine.model.file;

import java.io.ByteArrayOutputStream;
import java.net.URLDecoder;
import java.nio.charset.StandardCharsets;
import java.util.Base64;
import java.util.function.Function;
import nephele.engine.model.MeshLimits;
import nephele.engine.model.ModelText;

/**
 * The concatenated buffers of a glTF file.
 *
 * @param starts offset of each buffer in bytes
 * @param lengths length of each buffer in bytes
 */
record GltfBuffers(byte[] bytes, int[] starts, int[] lengths) {
    private static final int MOST_BUFFERS = 64;
    private static final int ALIGNMENT_BYTES = 4;

    /** @param neighbour returns the bytes of a file in the same folder, {@code null} if there is none */
    static GltfBuffers of(GltfValue buffers, byte[] binary, Function<String, byte[]> neighbour) {
        if (buffers.size() > MOST_BUFFERS) {
            throw buffers.error("has more than " + MOST_BUFFERS + " elements");
        }
        var bytes = new ByteArrayOutputStream();
        int[] starts = new int[buffers.size()];
        int[] lengths = new int[buffers.size()];
        for (int i = 0; i < starts.length; i++) {
            GltfValue buffer = buffers.at(i);
            byte[] data = bytesOf(buffer, i == 0 ? binary : null, neighbour);
            starts[i] = bytes.size();
            lengths[i] = buffer.member("byteLength").count();
            if (lengths[i] > data.length) {
                throw buffer.member("byteLength")
                        .error("is " + lengths[i] + ", but there are " + data.length + " bytes");
            }
            if ((long) bytes.size() + lengths[i] > MeshLimits.MAX_GLTF_BYTES) {
                throw buffers.error(
                        "hold more than " + (MeshLimits.MAX_GLTF_BYTES >> 20) + " MiB", "make the mesh coarser");
            }
            bytes.write(data, 0, lengths[i]);
            bytes.write(new byte[ALIGNMENT_BYTES], 0, -lengths[i] & (ALIGNMENT_BYTES - 1));
        }
        return new GltfBuffers(bytes.toByteArray(), starts, lengths);
    }

    private static byte[] bytesOf(GltfValue buffer, byte[] binary, Function<String, byte[]> neighbour) {
        GltfValue uri = buffer.member("uri");
        if (!uri.exists()) {
            if (binary == null) {
                throw uri.error("is missing, and the file holds no binary chunk for it");
            }
            return binary;
        }
        String text = uri.text("");
        return text.startsWith("data:") ? embedded(uri, text) : beside(uri, text, neighbour);
    }

    private static byte[] embedded(GltfValue uri, String text) {
        int comma = text.indexOf(',');
        if (comma < 0 || !text.substring(0, comma).endsWith(";base64")) {
            throw uri.error("is no base64 data");
        }
        try {
            return Base64.getDecoder().decode(text.substring(comma + 1).getBytes(StandardCharsets.ISO_8859_1));
        } catch (IllegalArgumentException notBase64) {
            throw uri.error("is no valid base64 data");
        }
    }

    /** Reads a file below the glTF file's own folder; nothing is fetched from elsewhere. */
    private static byte[] beside(GltfValue uri, String text, Function<String, byte[]> neighbour) {
        String name = decoded(uri, text);
        boolean elsewhere = name.isEmpty() || name.contains(":") || name.contains("\\") || name.startsWith("/");
        if (elsewhere || ("/" + name + "/").contains("/../")) {
            throw uri.error("names no file beside this one", "put the buffer there, or embed it");
        }
        byte[] bytes = neighbour.apply(name);
        if (bytes == null) {
            throw uri.error("names " + ModelText.quoted(name) + ", which is not there", "put the file beside this one");
        }
        return bytes;
    }

    private static String decoded(GltfValue uri, String text) {
        try {
            return URLDecoder.decode(text.replace("+", "%2B"), StandardCharsets.UTF_8);
        } catch (IllegalArgumentException notEncoded) {
            throw uri.error("is no address");
        }
    }
}
