package nephele.engine.model.file;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import nephele.engine.asset.MessageText;
import nephele.engine.math.Normals;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.ItemList;
import nephele.engine.model.Mesh;
import nephele.engine.model.MeshLimits;
import nephele.engine.model.ModelFileException;
import nephele.engine.model.file.GltfPrimitive.TextureMap;
import org.joml.Matrix3d;
import org.joml.Matrix4d;
import org.joml.Quaterniond;
import org.joml.Vector3d;

/**
 * Walks the drawn scene of a glTF file: nodes with their frames, whose meshes it joins into one. Each mesh is checked
 * once; its triangles are counted once for each node, before they are read. Everything else is skipped; what then differs
 * from the picture that the file asks for is reported.
 */
final class GltfScene {
    private static final int MOST_NODES = 10_000;

    private final GltfValue root;
    private final GltfAccessors accessors;
    private final Set<String> skipped = new TreeSet<>();

    /** True for each node that was visited. */
    private final boolean[] met;

    private final Map<Integer, List<GltfPrimitive>> meshes = new HashMap<>();
    private final FloatList positions = new FloatList();
    private final FloatList normals = new FloatList();
    private final FloatList textureCoordinates = new FloatList();
    private final ItemList indices = new ItemList();
    private long cost;

    private record Step(GltfValue index, Matrix4d parentFrame) {}

    GltfScene(GltfValue root, GltfAccessors accessors) {
        this.root = root;
        this.accessors = accessors;
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

    /** Returns the meshes of all drawn nodes as one. */
    Mesh mesh() {
        GltfValue scenes = root.member("scenes");
        int drawn = root.member("scene").exists() ? root.member("scene").index(scenes.size(), "scenes") : 0;
        if (scenes.size() == 0) {
            throw scenes.error("is missing: nothing says which nodes are shown");
        }
        Deque<Step> steps = new ArrayDeque<>();
        for (GltfValue node : scenes.at(drawn).member("nodes").elements()) {
            steps.add(new Step(node, new Matrix4d()));
        }
        while (!steps.isEmpty()) {
            visit(steps.remove(), steps);
        }
        return joined();
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
            add(node.member("mesh"), frame);
            noteMorphed(node);
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

    /** Adds a node's mesh; {@code index} is its number in the JSON. */
    private void add(GltfValue index, Matrix4d frame) {
        GltfValue all = root.member("meshes");
        int number = index.index(all.size(), "meshes");
        List<GltfPrimitive> primitives = meshes.computeIfAbsent(number, key -> primitives(all.at(key)));
        for (GltfPrimitive primitive : primitives) {
            cost += primitive.cost();
            if (cost > MeshLimits.MAX_GLTF_VERTICES) {
                throw index.error(
                        "makes it more than " + MeshLimits.MAX_GLTF_VERTICES + " vertices or triangles",
                        "make the mesh coarser");
            }
            add(primitive, frame);
        }
    }

    private Mesh joined() {
        if (indices.size() == 0) {
            throw wrong("holds no triangles", "export a mesh of triangles");
        }
        float[] places = positions.toArray();
        float[] unit = normals.toArray();
        int[] corners = indices.toArray();
        MissingNormals.fill(places, unit, corners);
        return new Mesh(places, unit, textureCoordinates.toArray(), corners);
    }

    /** Notes the morph targets of a mesh, or of the node that uses it, if its weights show any. */
    private void noteMorphed(GltfValue weighted) {
        for (GltfValue weight : weighted.member("weights").elements()) {
            if (weight.number() != 0) {
                skipped.add("morph targets");
            }
        }
    }

    private List<GltfPrimitive> primitives(GltfValue mesh) {
        noteMorphed(mesh);
        List<GltfPrimitive> primitives = new ArrayList<>();
        for (GltfValue primitive : mesh.member("primitives").elements()) {
            int mode = primitive.member("mode").count(GltfPrimitive.TRIANGLES);
            if (mode > GltfPrimitive.TRIANGLE_FAN) {
                throw primitive.member("mode").error("is " + mode + ", which draws nothing known");
            }
            if (mode >= GltfPrimitive.TRIANGLES) {
                primitives.add(GltfPrimitive.of(root, primitive, mode, accessors));
            }
        }
        return primitives;
    }

    private void add(GltfPrimitive primitive, Matrix4d frame) {
        int first = positions.size() / 3;
        int count = primitive.positions().count();
        addPositions(primitive.positions().numbers(), frame);
        addNormals(
                primitive.normals() == null
                        ? new double[3 * count]
                        : primitive.normals().numbers(),
                frame);
        addTexture(primitive.texture() == null ? null : primitive.texture().numbers(), count, primitive.map());
        boolean mirrored = Normals.flipsWinding(frame.get3x3(new Matrix3d()));
        int[] corners = corners(primitive.indices(), count);
        int mode = primitive.mode();
        for (int i = 0; i + 2 < corners.length; i += mode == GltfPrimitive.TRIANGLES ? 3 : 1) {
            boolean odd = mode == GltfPrimitive.TRIANGLE_STRIP && i % 2 == 1;
            int a = mode == GltfPrimitive.TRIANGLE_FAN ? corners[0] : corners[i];
            addTriangle(first + a, first + corners[i + 1], first + corners[i + 2], mirrored != odd);
        }
    }

    private void addTriangle(int a, int b, int c, boolean turned) {
        indices.accept(a);
        indices.accept(turned ? c : b);
        indices.accept(turned ? b : c);
    }

    private void addPositions(double[] numbers, Matrix4d frame) {
        Vector3d point = new Vector3d();
        for (int i = 0; i < numbers.length; i += 3) {
            frame.transformPosition(point.set(numbers[i], numbers[i + 1], numbers[i + 2]));
            addCoordinate(positions, point.x);
            addCoordinate(positions, point.y);
            addCoordinate(positions, point.z);
        }
    }

    private void addNormals(double[] numbers, Matrix4d frame) {
        Matrix3d linear = frame.get3x3(new Matrix3d());
        for (int i = 0; i < numbers.length; i += 3) {
            Vec3 unit = transformed(linear, new Vec3(numbers[i], numbers[i + 1], numbers[i + 2]));
            normals.add(unit.x());
            normals.add(unit.y());
            normals.add(unit.z());
        }
    }

    /** Returns the transformed normal; zero if it has no direction, so that it is computed from the triangles later. */
    private static Vec3 transformed(Matrix3d linear, Vec3 normal) {
        double squared = normal.toVector().lengthSquared();
        return squared > 0 && Double.isFinite(squared) ? Normals.transformed(linear, normal) : Vec3.ZERO;
    }

    /**
     * Adds texture coordinates; glTF's origin is the top of the image, the mesh's the bottom.
     *
     * @param numbers {@code null} without any
     */
    private void addTexture(double[] numbers, int count, TextureMap map) {
        for (int i = 0; i < count; i++) {
            addCoordinate(textureCoordinates, numbers == null ? 0 : map.s() + map.scaleS() * numbers[2 * i]);
            addCoordinate(textureCoordinates, numbers == null ? 0 : 1 - map.t() - map.scaleT() * numbers[2 * i + 1]);
        }
    }

    private void addCoordinate(FloatList list, double value) {
        if (!(Math.abs(value) <= MeshLimits.MAX_COORDINATE_UNITS)) {
            throw wrong(MessageText.number(value) + " in a buffer is no coordinate", "keep within a million units");
        }
        list.add(value + 0.0);
    }

    /** @param listed {@code null} for the vertices in their order */
    private int[] corners(GltfAccessor listed, int vertices) {
        int[] corners = new int[listed == null ? vertices : listed.count()];
        double[] numbers = listed == null ? null : listed.numbers();
        for (int i = 0; i < corners.length; i++) {
            double corner = numbers == null ? i : numbers[i];
            if (corner >= vertices) {
                throw wrong(
                        "index " + (long) corner + " in a buffer names no vertex; there are " + vertices,
                        "export the mesh again");
            }
            corners[i] = (int) corner;
        }
        return corners;
    }

    private ModelFileException wrong(String reason, String remedy) {
        return new ModelFileException(root.file(), 0, reason, remedy);
    }
}
