package nephele.engine.model.file;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import nephele.engine.model.MeshLimits;

/** The accessors that meshes use; each is checked to be within its buffer view. */
final class GltfAccessors {
    private static final int UNSIGNED_BYTE = 5121;
    private static final int UNSIGNED_SHORT = 5123;
    private static final int UNSIGNED_INT = 5125;
    private static final int FLOAT = 5126;

    static final List<Integer> FLOATS = List.of(FLOAT);

    /** Component types of numbers from 0 to 1, including normalized integers. */
    static final List<Integer> FLOATS_OR_SHARES = List.of(FLOAT, UNSIGNED_BYTE, UNSIGNED_SHORT);

    static final List<Integer> INDICES = List.of(UNSIGNED_BYTE, UNSIGNED_SHORT, UNSIGNED_INT);

    private final GltfValue root;
    private final GltfBuffers buffers;
    private final JsonArray accessors = new JsonArray();
    private final JsonArray views = new JsonArray();
    private final Map<Integer, Integer> numbers = new HashMap<>();

    GltfAccessors(GltfValue root, GltfBuffers buffers) {
        this.root = root;
        this.buffers = buffers;
    }

    /** Checks an accessor and returns its index among those kept. */
    int use(GltfValue index, String type, List<Integer> components) {
        GltfValue all = root.member("accessors");
        int number = index.index(all.size(), "accessors");
        GltfValue accessor = all.at(number);
        int component = accessor.member("componentType").count();
        if (!accessor.member("type").text("").equals(type) || !components.contains(component)) {
            throw accessor.error("has not the type that " + index.path() + " needs");
        }
        if (components != INDICES
                && component != FLOAT
                && !accessor.member("normalized").flag()) {
            throw accessor.member("normalized").error("has to be true for texture coordinates in whole numbers");
        }
        if (!numbers.containsKey(number)) {
            numbers.put(number, accessors.size());
            accessors.add(checked(accessor, type, component));
        }
        return numbers.get(number);
    }

    int count(int kept) {
        return accessors.get(kept).getAsJsonObject().get("count").getAsInt();
    }

    JsonObject checked() {
        JsonObject buffer = new JsonObject();
        buffer.addProperty("byteLength", buffers.bytes().length);
        JsonArray one = new JsonArray();
        one.add(buffer);
        JsonObject asset = new JsonObject();
        asset.addProperty("version", "2.0");
        JsonObject all = new JsonObject();
        all.add("asset", asset);
        all.add("buffers", one);
        all.add("bufferViews", views);
        all.add("accessors", accessors);
        return all;
    }

    private JsonObject checked(GltfValue accessor, String type, int component) {
        if (accessor.member("sparse").exists()) {
            throw accessor.member("sparse").error("can't be read", "export without sparse accessors");
        }
        int size = component == UNSIGNED_BYTE ? 1 : component == UNSIGNED_SHORT ? 2 : 4;
        int width = type.equals("VEC3") ? 3 : type.equals("VEC2") ? 2 : 1;
        int count = accessor.member("count").count();
        if (count < 1 || count > 3 * MeshLimits.MAX_GLTF_VERTICES) {
            throw accessor.member("count").error("is " + count, "keep within 1 to " + 3 * MeshLimits.MAX_GLTF_VERTICES);
        }
        GltfValue allViews = root.member("bufferViews");
        GltfValue view = allViews.at(accessor.member("bufferView").index(allViews.size(), "buffer views"));
        JsonObject part = view(view);
        int stride = view.member("byteStride").count(size * width);
        int offset = accessor.member("byteOffset").count(0);
        checkRange(
                accessor,
                new Range(offset, stride, count, size * width),
                part.get("byteLength").getAsInt());
        if (stride % size != 0 || (offset + part.get("byteOffset").getAsInt()) % size != 0) {
            throw accessor.error("does not begin or step at a multiple of its components' size");
        }
        JsonObject kept = new JsonObject();
        kept.addProperty("bufferView", views.size());
        kept.addProperty("byteOffset", offset);
        kept.addProperty("componentType", component);
        kept.addProperty("normalized", accessor.member("normalized").flag());
        kept.addProperty("count", count);
        kept.addProperty("type", type);
        views.add(part);
        return kept;
    }

    private record Range(int offset, int stride, int count, int elementBytes) {
        long end() {
            return offset + (long) stride * (count - 1) + elementBytes;
        }
    }

    private static void checkRange(GltfValue accessor, Range range, int bytes) {
        if (range.stride < range.elementBytes) {
            throw accessor.error("steps by " + range.stride + " bytes over elements of " + range.elementBytes);
        }
        if (range.end() > bytes) {
            throw accessor.error("ends at byte " + range.end() + " of a buffer view of " + bytes);
        }
    }

    /** Returns the view relative to the one buffer into which all buffers are joined. */
    private JsonObject view(GltfValue view) {
        int buffer = view.member("buffer").index(buffers.starts().length, "buffers");
        int offset = view.member("byteOffset").count(0);
        int length = view.member("byteLength").count();
        if ((long) offset + length > buffers.lengths()[buffer]) {
            throw view.error(
                    "ends at byte " + ((long) offset + length) + " of a buffer of " + buffers.lengths()[buffer]);
        }
        JsonObject kept = new JsonObject();
        kept.addProperty("buffer", 0);
        kept.addProperty("byteOffset", buffers.starts()[buffer] + offset);
        kept.addProperty("byteLength", length);
        GltfValue stride = view.member("byteStride");
        if (stride.exists()) {
            if (stride.count() > 252) {
                throw stride.error("is more than 252");
            }
            kept.addProperty("byteStride", stride.count());
        }
        return kept;
    }
}
