package nephele.engine.model.file;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import nephele.engine.math.Normals;
import nephele.engine.math.Vec3;
import nephele.engine.model.Mesh;
import nephele.engine.model.MeshLimits;
import nephele.engine.model.ModelFileException;
import nephele.engine.model.NumberFormatting;
import nephele.engine.model.file.GltfPrimitive.TextureMap;
import org.joml.Matrix3d;
import org.joml.Matrix4d;
import org.joml.Vector3d;

/**
 * Joins the meshes of nodes into one. Each mesh is checked once; its triangles are counted once for each node, before
 * they are read.
 */
final class GltfTriangles {
    private final GltfValue root;
    private final GltfAccessors accessors;
    private final Set<String> skipped;
    private final Map<Integer, List<GltfPrimitive>> meshes = new HashMap<>();
    private final FloatList positions = new FloatList();
    private final FloatList normals = new FloatList();
    private final FloatList textureCoordinates = new FloatList();
    private final IntList indices = new IntList();
    private long cost;

    /** @param skipped receives the names of what is not applied */
    GltfTriangles(GltfValue root, GltfBuffers buffers, Set<String> skipped) {
        this.root = root;
        this.skipped = skipped;
        this.accessors = new GltfAccessors(root, buffers);
    }

    /** Adds a node's mesh; {@code index} is its number in the JSON. */
    void add(GltfValue index, Matrix4d frame) {
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

    Mesh mesh() {
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
    static void tellMorphed(GltfValue weighted, Set<String> skipped) {
        for (GltfValue weight : weighted.member("weights").elements()) {
            if (weight.number() != 0) {
                skipped.add("morph targets");
            }
        }
    }

    private List<GltfPrimitive> primitives(GltfValue mesh) {
        tellMorphed(mesh, skipped);
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
        indices.add(a);
        indices.add(turned ? c : b);
        indices.add(turned ? b : c);
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
            throw wrong(NumberFormatting.of(value) + " in a buffer is no coordinate", "keep within a million units");
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
