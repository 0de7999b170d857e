package nephele.engine.model.file;

import java.net.URLDecoder;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import java.util.function.Function;
import nephele.engine.asset.AssetException;
import nephele.engine.model.MeshLimits;
import nephele.engine.model.ModelText;

/** The buffers of a glTF file, little-endian, each as long as the file says. */
record GltfBuffers(List<ByteBuffer> all) {
    private static final int MOST_BUFFERS = 64;

    /** @param neighbour returns the bytes of a file in the same folder, {@code null} if there is none */
    static GltfBuffers of(GltfValue buffers, byte[] binary, Function<String, byte[]> neighbour) {
        if (buffers.size() > MOST_BUFFERS) {
            throw buffers.error("has more than " + MOST_BUFFERS + " elements");
        }
        List<ByteBuffer> all = new ArrayList<>();
        long total = 0;
        for (int i = 0; i < buffers.size(); i++) {
            GltfValue buffer = buffers.at(i);
            byte[] data = bytesOf(buffer, i == 0 ? binary : null, neighbour);
            int length = buffer.member("byteLength").count();
            if (length > data.length) {
                throw buffer.member("byteLength").error("is " + length + ", but there are " + data.length + " bytes");
            }
            total += length;
            if (total > MeshLimits.MAX_GLTF_BYTES) {
                throw buffers.error(
                        "hold more than " + (MeshLimits.MAX_GLTF_BYTES >> 20) + " MiB", "make the mesh coarser");
            }
            byte[] kept = length == data.length ? data : Arrays.copyOf(data, length);
            all.add(ByteBuffer.wrap(kept).order(ByteOrder.LITTLE_ENDIAN));
        }
        return new GltfBuffers(all);
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
        String named = "names " + ModelText.quoted(name) + ", which ";
        byte[] bytes;
        try {
            bytes = neighbour.apply(name);
        } catch (AssetException unusable) {
            throw uri.error(named + unusable.reason(), unusable.remedy());
        }
        if (bytes == null) {
            throw uri.error(named + "is not there", "put the file beside this one");
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
