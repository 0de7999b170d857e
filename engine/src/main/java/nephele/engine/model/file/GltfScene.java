package nephele.engine.model.file;

import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;

/**
 * Extracts the shown scene of a glTF file: nodes with their transforms, and their meshes. Everything else is dropped.
 */
final class GltfScene {
    private static final int MOST_NODES = 10_000;
    private static final List<String> FRAME = List.of("matrix", "translation", "rotation", "scale");

    private final GltfValue root;
    private final GltfMeshes meshes;
    private final JsonArray nodes = new JsonArray();
    private final JsonArray roots = new JsonArray();

    /** True for each node that was visited. */
    private final boolean[] met;

    private record Step(GltfValue index, JsonArray siblings) {}

    GltfScene(GltfValue root, GltfBuffers buffers) {
        this.root = root;
        this.meshes = new GltfMeshes(root, buffers);
        int count = root.member("nodes").size();
        if (count > MOST_NODES) {
            throw root.member("nodes").error("has more than " + MOST_NODES + " elements", "join the meshes");
        }
        this.met = new boolean[count];
    }

    /** Returns a self-contained glTF file in which all numbers are validated. */
    JsonObject checked() {
        walk();
        JsonObject all = meshes.checked();
        JsonObject scene = new JsonObject();
        scene.add("nodes", roots);
        JsonArray scenes = new JsonArray();
        scenes.add(scene);
        all.add("nodes", nodes);
        all.add("scenes", scenes);
        all.addProperty("scene", 0);
        return all;
    }

    private void walk() {
        GltfValue scenes = root.member("scenes");
        int shown = root.member("scene").exists() ? root.member("scene").index(scenes.size(), "scenes") : 0;
        if (scenes.size() == 0) {
            throw scenes.error("is missing: nothing says which nodes are shown");
        }
        Deque<Step> steps = new ArrayDeque<>();
        for (GltfValue node : scenes.at(shown).member("nodes").elements()) {
            steps.add(new Step(node, roots));
        }
        while (!steps.isEmpty()) {
            visit(steps.remove(), steps);
        }
    }

    private void visit(Step step, Deque<Step> steps) {
        int number = step.index.index(met.length, "nodes");
        if (met[number]) {
            throw step.index.error("leads to node " + number + " a second time", "give each node one parent");
        }
        met[number] = true;
        GltfValue node = root.member("nodes").at(number);
        JsonObject kept = new JsonObject();
        FRAME.forEach(name -> keepFrame(node.member(name), name, kept));
        if (node.member("mesh").exists()) {
            kept.addProperty("mesh", meshes.use(node.member("mesh")));
        }
        step.siblings.add(nodes.size());
        nodes.add(kept);
        JsonArray children = new JsonArray();
        for (GltfValue child : node.member("children").elements()) {
            steps.add(new Step(child, children));
        }
        if (node.member("children").size() > 0) {
            kept.add("children", children);
        }
    }

    private static void keepFrame(GltfValue frame, String name, JsonObject kept) {
        if (!frame.exists()) {
            return;
        }
        int wanted = name.equals("matrix") ? 16 : name.equals("rotation") ? 4 : 3;
        if (frame.size() != wanted) {
            throw frame.error("has " + frame.size() + " numbers instead of " + wanted);
        }
        frame.elements().forEach(GltfValue::number);
        kept.add(name, frame.json());
    }
}
