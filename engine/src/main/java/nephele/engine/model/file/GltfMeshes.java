package nephele.engine.model.file;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import nephele.engine.model.MeshLimits;

/** The meshes that nodes use. Each is checked once; its triangles are counted once for each node. */
final class GltfMeshes {
    private static final int TRIANGLES = 4;
    private static final int TRIANGLE_STRIP = 5;
    private static final int TRIANGLE_FAN = 6;

    private final GltfValue root;
    private final GltfAccessors accessors;
    private final JsonArray meshes = new JsonArray();
    private final Map<Integer, Integer> numbers = new HashMap<>();
    private final Map<Integer, Long> costs = new HashMap<>();
    private long cost;

    GltfMeshes(GltfValue root, GltfBuffers buffers) {
        this.root = root;
        this.accessors = new GltfAccessors(root, buffers);
    }

    /** Checks a node's mesh and returns its index among those kept. */
    int use(GltfValue index) {
        GltfValue all = root.member("meshes");
        int number = index.index(all.size(), "meshes");
        if (!numbers.containsKey(number)) {
            numbers.put(number, meshes.size());
            meshes.add(mesh(all.at(number), number));
        }
        cost += costs.get(number);
        if (cost > MeshLimits.MAX_GLTF_VERTICES) {
            throw index.error(
                    "makes it more than " + MeshLimits.MAX_GLTF_VERTICES + " vertices or triangles",
                    "make the mesh coarser");
        }
        return numbers.get(number);
    }

    JsonObject checked() {
        JsonObject all = accessors.checked();
        all.add("meshes", meshes);
        return all;
    }

    private JsonObject mesh(GltfValue mesh, int number) {
        JsonArray kept = new JsonArray();
        long cost = 0;
        for (GltfValue primitive : mesh.member("primitives").elements()) {
            int mode = primitive.member("mode").count(TRIANGLES);
            if (mode > TRIANGLE_FAN) {
                throw primitive.member("mode").error("is " + mode + ", which draws nothing known");
            }
            if (mode >= TRIANGLES) {
                JsonObject checked = primitive(primitive, mode);
                cost += cost(checked, mode);
                kept.add(checked);
            }
        }
        costs.put(number, cost);
        JsonObject result = new JsonObject();
        result.add("primitives", kept);
        return result;
    }

    private JsonObject primitive(GltfValue primitive, int mode) {
        GltfValue attributes = primitive.member("attributes");
        if (!attributes.exists()) {
            throw attributes.error("is missing");
        }
        JsonObject kept = new JsonObject();
        int position = accessors.use(attributes.member("POSITION"), "VEC3", GltfAccessors.FLOATS);
        kept.addProperty("POSITION", position);
        keep(kept, attributes.member("NORMAL"), "VEC3", GltfAccessors.FLOATS, position);
        keep(kept, attributes.member("TEXCOORD_0"), "VEC2", GltfAccessors.FLOATS_OR_SHARES, position);
        JsonObject result = new JsonObject();
        result.addProperty("mode", mode);
        result.add("attributes", kept);
        GltfValue indices = primitive.member("indices");
        if (indices.exists()) {
            result.addProperty("indices", accessors.use(indices, "SCALAR", GltfAccessors.INDICES));
        }
        int count = accessors.count(indices.exists() ? result.get("indices").getAsInt() : position);
        if (mode == TRIANGLES && count % 3 != 0) {
            throw primitive.error("has " + count + " corners, which is no multiple of three");
        }
        return result;
    }

    private void keep(JsonObject kept, GltfValue index, String type, List<Integer> components, int position) {
        if (!index.exists()) {
            return;
        }
        int accessor = accessors.use(index, type, components);
        if (accessors.count(accessor) != accessors.count(position)) {
            throw index.error(
                    "has " + accessors.count(accessor) + " elements for " + accessors.count(position) + " positions");
        }
        kept.addProperty(index.path().substring(index.path().lastIndexOf('.') + 1), accessor);
    }

    /** Returns the larger of the numbers of vertices and triangles. */
    private long cost(JsonObject primitive, int mode) {
        long vertices = accessors.count(
                primitive.getAsJsonObject("attributes").get("POSITION").getAsInt());
        long listed = primitive.has("indices")
                ? accessors.count(primitive.get("indices").getAsInt())
                : vertices;
        return Math.max(vertices, mode >= TRIANGLE_STRIP ? listed : listed / 3);
    }
}
