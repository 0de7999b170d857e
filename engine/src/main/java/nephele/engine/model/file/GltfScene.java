package nephele.engine.model.file;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Set;
import java.util.TreeSet;
import nephele.engine.model.Mesh;
import org.joml.Matrix4d;
import org.joml.Quaterniond;
import org.joml.Vector3d;

/**
 * Walks the shown scene of a glTF file: nodes with their frames, and their meshes. Everything else is skipped; what then
 * differs from the picture that the file asks for is told.
 */
final class GltfScene {
    private static final int MOST_NODES = 10_000;

    private final GltfValue root;
    private final GltfTriangles triangles;
    private final Set<String> skipped = new TreeSet<>();

    /** True for each node that was visited. */
    private final boolean[] met;

    private record Step(GltfValue index, Matrix4d parentFrame) {}

    GltfScene(GltfValue root, GltfBuffers buffers) {
        this.root = root;
        this.triangles = new GltfTriangles(root, buffers, skipped);
        int count = root.member("nodes").size();
        if (count > MOST_NODES) {
            throw root.member("nodes").error("has more than " + MOST_NODES + " elements", "join the meshes");
        }
        this.met = new boolean[count];
    }

    /** Returns what the mesh lacks, such as skins; empty for nothing. Known once {@link #mesh} has returned. */
    Set<String> skipped() {
        return skipped;
    }

    /** Returns the meshes of all shown nodes as one. */
    Mesh mesh() {
        GltfValue scenes = root.member("scenes");
        int shown = root.member("scene").exists() ? root.member("scene").index(scenes.size(), "scenes") : 0;
        if (scenes.size() == 0) {
            throw scenes.error("is missing: nothing says which nodes are shown");
        }
        Deque<Step> steps = new ArrayDeque<>();
        for (GltfValue node : scenes.at(shown).member("nodes").elements()) {
            steps.add(new Step(node, new Matrix4d()));
        }
        while (!steps.isEmpty()) {
            visit(steps.remove(), steps);
        }
        return triangles.mesh();
    }

    private void visit(Step step, Deque<Step> steps) {
        int number = step.index.index(met.length, "nodes");
        if (met[number]) {
            throw step.index.error("leads to node " + number + " a second time", "give each node one parent");
        }
        met[number] = true;
        GltfValue node = root.member("nodes").at(number);
        Matrix4d frame = step.parentFrame.mul(frame(node), new Matrix4d());
        if (node.member("mesh").exists()) {
            triangles.add(node.member("mesh"), frame);
            GltfTriangles.tellMorphed(node, skipped);
            if (node.member("skin").exists()) {
                skipped.add("skins");
            }
        }
        for (GltfValue child : node.member("children").elements()) {
            steps.add(new Step(child, frame));
        }
    }

    /** Returns a node's frame in its parent's (glTF 2.0, 3.5.2): a matrix by columns, or scale, rotation, translation. */
    private static Matrix4d frame(GltfValue node) {
        double[] translation = numbers(node.member("translation"), 0, 0, 0);
        double[] rotation = numbers(node.member("rotation"), 0, 0, 0, 1);
        double[] scale = numbers(node.member("scale"), 1, 1, 1);
        double[] matrix = numbers(node.member("matrix"), new double[16]);
        if (node.member("matrix").exists()) {
            return new Matrix4d().set(matrix);
        }
        Quaterniond turn = new Quaterniond(rotation[0], rotation[1], rotation[2], rotation[3]);
        if (!(turn.lengthSquared() > 0)) {
            throw node.member("rotation").error("is no rotation: its length is 0");
        }
        return new Matrix4d().translationRotateScale(new Vector3d(translation), turn.normalize(), new Vector3d(scale));
    }

    private static double[] numbers(GltfValue array, double... missing) {
        double[] numbers = missing.clone();
        for (int i = 0; i < numbers.length; i++) {
            numbers[i] = array.numberAt(i, numbers.length, missing[i]);
        }
        return numbers;
    }
}
