package nephele.engine.model.file;

import java.net.URLDecoder;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import java.util.Set;
import java.util.function.Function;
import nephele.engine.asset.AssetException;
import nephele.engine.model.MeshLimits;
import nephele.engine.model.ModelText;
import nephele.engine.model.file.GltfAccessor.Elements;
import nephele.engine.model.file.GltfAccessor.Format;
import nephele.engine.model.file.GltfAccessor.Sparse;

/**
 * Finds the accessors that meshes use, and checks that each is of the right type and within its buffer views. The buffers
 * are little-endian, each as long as the file says.
 */
final class GltfAccessors {
    /** The extension that permits integers for all attributes. */
    static final String QUANTIZATION = "KHR_mesh_quantization";

    private static final Set<Integer> WHOLE =
            Set.of(GltfAccessor.UNSIGNED_BYTE, GltfAccessor.UNSIGNED_SHORT, GltfAccessor.UNSIGNED_INT);
    private static final Set<Integer> FLOATS = Set.of(GltfAccessor.FLOAT);
    private static final Set<Integer> FRACTIONS =
            Set.of(GltfAccessor.FLOAT, GltfAccessor.UNSIGNED_BYTE, GltfAccessor.UNSIGNED_SHORT);
    private static final Set<Integer> QUANTIZED = Set.of(
            GltfAccessor.FLOAT,
            GltfAccessor.BYTE,
            GltfAccessor.UNSIGNED_BYTE,
            GltfAccessor.SHORT,
            GltfAccessor.UNSIGNED_SHORT);
    private static final int MOST_BUFFERS = 64;
    private static final int MOST_STRIDE_BYTES = 252;

    /** What an accessor is used for, with its type and permitted components, also under {@link #QUANTIZATION}. */
    enum Use {
        POSITION("VEC3", 3, FLOATS, QUANTIZED),
        NORMAL("VEC3", 3, FLOATS, Set.of(GltfAccessor.FLOAT, GltfAccessor.BYTE, GltfAccessor.SHORT)),
        TEXCOORD_0("VEC2", 2, FRACTIONS, QUANTIZED),
        INDICES("SCALAR", 1, WHOLE, WHOLE);

        private final String type;
        private final int width;
        private final Set<Integer> plain;
        private final Set<Integer> quantized;

        Use(String type, int width, Set<Integer> plain, Set<Integer> quantized) {
            this.type = type;
            this.width = width;
            this.plain = plain;
            this.quantized = quantized;
        }
    }

    private final GltfValue root;
    private final List<ByteBuffer> buffers;
    private final boolean isQuantized;

    /**
     * Reads the file's buffers.
     *
     * @param binary the buffer in a .glb; {@code null} without one
     * @param neighbour returns the bytes of a file in the same folder, {@code null} if there is none
     */
    GltfAccessors(GltfValue root, byte[] binary, Function<String, byte[]> neighbour) {
        this.root = root;
        buffers = buffers(root.member("buffers"), binary, neighbour);
        boolean quantized = false;
        for (GltfValue extension : root.member("extensionsUsed").elements()) {
            quantized |= extension.text("").equals(QUANTIZATION);
        }
        this.isQuantized = quantized;
    }

    /** Returns the accessor of an index in the JSON. */
    GltfAccessor use(GltfValue index, Use use) {
        GltfValue all = root.member("accessors");
        GltfValue authored = all.at(index.index(all.size(), "accessors"));
        Format format = format(authored, index, use);
        int count = authored.member("count").count();
        if (count < 1 || count > 3 * MeshLimits.MAX_GLTF_VERTICES) {
            throw authored.member("count").error("is " + count, "keep within 1 to " + 3 * MeshLimits.MAX_GLTF_VERTICES);
        }
        int bytes = use.width * format.bytes();
        Elements dense = authored.member("bufferView").exists() ? elements(authored, format, count, bytes) : null;
        GltfValue sparse = authored.member("sparse");
        return new GltfAccessor(
                authored, count, use.width, dense, sparse.exists() ? sparse(sparse, format, count, bytes) : null);
    }

    private Format format(GltfValue authored, GltfValue index, Use use) {
        int component = authored.member("componentType").count();
        Set<Integer> permitted = isQuantized ? use.quantized : use.plain;
        if (!authored.member("type").text("").equals(use.type) || !permitted.contains(component)) {
            throw authored.error("has not the type that " + index.path() + " needs");
        }
        boolean isNormalized =
                use != Use.INDICES && authored.member("normalized").flag();
        if (use == Use.TEXCOORD_0 && component != GltfAccessor.FLOAT && !isNormalized && !isQuantized) {
            throw authored.member("normalized").error("has to be true for texture coordinates in whole numbers");
        }
        return new Format(component, isNormalized);
    }

    private Sparse sparse(GltfValue authored, Format format, int count, int bytes) {
        GltfValue indices = authored.member("indices");
        GltfValue values = authored.member("values");
        if (!authored.member("count").exists() || !indices.exists() || !values.exists()) {
            throw authored.error("lacks its count, indices or values");
        }
        int number = authored.member("count").count();
        if (number < 1 || number > count) {
            throw authored.member("count").error("is " + number + " of " + count + " elements");
        }
        var whole = new Format(indices.member("componentType").count(), false);
        if (!WHOLE.contains(whole.component())) {
            throw indices.member("componentType").error("is no type of indices");
        }
        return new Sparse(
                authored,
                number,
                elements(indices, whole, number, whole.bytes()),
                elements(values, format, number, bytes));
    }

    /** Returns the elements that {@code authored} describes by {@code bufferView} and {@code byteOffset}. */
    private Elements elements(GltfValue authored, Format format, int count, int bytes) {
        GltfValue allViews = root.member("bufferViews");
        GltfValue view = allViews.at(authored.member("bufferView").index(allViews.size(), "buffer views"));
        int buffer = view.member("buffer").index(buffers.size(), "buffers");
        int start = view.member("byteOffset").count(0);
        int length = view.member("byteLength").count();
        int available = buffers.get(buffer).limit();
        if ((long) start + length > available) {
            throw view.error("ends at byte " + ((long) start + length) + " of a buffer of " + available);
        }
        int stride = stride(authored, view, bytes);
        int offset = authored.member("byteOffset").count(0);
        long end = offset + (long) stride * (count - 1) + bytes;
        if (end > length) {
            throw authored.error("ends at byte " + end + " of a buffer view of " + length);
        }
        if (stride % format.bytes() != 0 || (start + offset) % format.bytes() != 0) {
            throw authored.error("does not begin or step at a multiple of its components' size");
        }
        return new Elements(buffers.get(buffer), start + offset, stride, format);
    }

    private static int stride(GltfValue authored, GltfValue view, int bytes) {
        GltfValue given = view.member("byteStride");
        int stride = given.count(bytes);
        if (given.exists() && stride > MOST_STRIDE_BYTES) {
            throw given.error("is more than " + MOST_STRIDE_BYTES);
        }
        if (stride < bytes) {
            throw authored.error("steps by " + stride + " bytes over elements of " + bytes);
        }
        return stride;
    }

    private static List<ByteBuffer> buffers(GltfValue buffers, byte[] binary, Function<String, byte[]> neighbour) {
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
        return all;
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
