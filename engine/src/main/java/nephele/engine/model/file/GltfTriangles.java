package nephele.engine.model.file;

import de.javagl.jgltf.model.AccessorByteData;
import de.javagl.jgltf.model.AccessorData;
import de.javagl.jgltf.model.AccessorFloatData;
import de.javagl.jgltf.model.AccessorIntData;
import de.javagl.jgltf.model.AccessorModel;
import de.javagl.jgltf.model.AccessorShortData;
import de.javagl.jgltf.model.GltfModel;
import de.javagl.jgltf.model.MeshModel;
import de.javagl.jgltf.model.MeshPrimitiveModel;
import de.javagl.jgltf.model.NodeModel;
import java.util.IdentityHashMap;
import java.util.Map;
import nephele.engine.math.Normals;
import nephele.engine.math.Vec3;
import nephele.engine.model.Mesh;
import nephele.engine.model.MeshLimits;
import nephele.engine.model.ModelFileException;
import nephele.engine.model.NumberFormatting;
import org.joml.Matrix3d;
import org.joml.Matrix4d;
import org.joml.Vector3d;

/** Joins the meshes of a glTF scene's nodes into one, each transformed by its node. */
final class GltfTriangles {
    private static final int TRIANGLES = 4;
    private static final int TRIANGLE_STRIP = 5;
    private static final double BYTE_RANGE = 255;
    private static final double SHORT_RANGE = 65_535;

    private final String file;
    private final GltfModel model;
    private final FloatList positions = new FloatList();
    private final FloatList normals = new FloatList();
    private final FloatList textureCoordinates = new FloatList();
    private final IntList indices = new IntList();

    GltfTriangles(String file, GltfModel model) {
        this.file = file;
        this.model = model;
    }

    /** Returns the joined mesh; {@link GltfScene} orders parents before children. */
    Mesh mesh() {
        Map<NodeModel, Matrix4d> frames = new IdentityHashMap<>();
        for (NodeModel node : model.getNodeModels()) {
            Matrix4d parent = node.getParent() == null ? new Matrix4d() : frames.get(node.getParent());
            Matrix4d frame = parent.mul(new Matrix4d().set(node.computeLocalTransform(null)), new Matrix4d());
            frames.put(node, frame);
            add(node, frame);
        }
        if (indices.size() == 0) {
            throw wrong("holds no triangles", "export a mesh of triangles");
        }
        float[] places = positions.toArray();
        float[] unit = normals.toArray();
        int[] corners = indices.toArray();
        MissingNormals.fill(places, unit, corners);
        return new Mesh(places, unit, textureCoordinates.toArray(), corners);
    }

    private void add(NodeModel node, Matrix4d frame) {
        for (MeshModel mesh : node.getMeshModels()) {
            for (MeshPrimitiveModel primitive : mesh.getMeshPrimitiveModels()) {
                add(primitive, frame);
            }
        }
    }

    private void add(MeshPrimitiveModel primitive, Matrix4d frame) {
        int first = positions.size() / 3;
        AccessorModel position = primitive.getAttributes().get("POSITION");
        addPositions((AccessorFloatData) position.getAccessorData(), frame);
        addNormals(primitive.getAttributes().get("NORMAL"), position.getCount(), frame);
        addTexture(primitive.getAttributes().get("TEXCOORD_0"), position.getCount());
        boolean mirrored = Normals.flipsWinding(frame.get3x3(new Matrix3d()));
        int[] corners = corners(primitive.getIndices(), position.getCount());
        int mode = primitive.getMode();
        for (int i = 0; i + 2 < corners.length; i += mode == TRIANGLES ? 3 : 1) {
            boolean odd = mode == TRIANGLE_STRIP && i % 2 == 1;
            int a = mode > TRIANGLE_STRIP ? corners[0] : corners[i];
            addTriangle(first + a, first + corners[i + 1], first + corners[i + 2], mirrored != odd);
        }
    }

    private void addTriangle(int a, int b, int c, boolean turned) {
        indices.add(a);
        indices.add(turned ? c : b);
        indices.add(turned ? b : c);
    }

    private void addPositions(AccessorFloatData data, Matrix4d frame) {
        Vector3d point = new Vector3d();
        for (int i = 0; i < data.getNumElements(); i++) {
            frame.transformPosition(point.set(data.get(i, 0), data.get(i, 1), data.get(i, 2)));
            addCoordinate(positions, point.x);
            addCoordinate(positions, point.y);
            addCoordinate(positions, point.z);
        }
    }

    private void addNormals(AccessorModel normal, int count, Matrix4d frame) {
        Matrix3d linear = frame.get3x3(new Matrix3d());
        AccessorFloatData data = normal == null ? null : (AccessorFloatData) normal.getAccessorData();
        for (int i = 0; i < count; i++) {
            Vec3 unit = data == null ? Vec3.ZERO : transformed(linear, data, i);
            normals.add(unit.x());
            normals.add(unit.y());
            normals.add(unit.z());
        }
    }

    /** Returns the transformed normal; zero if it has no direction, so that it is computed from the triangles later. */
    private static Vec3 transformed(Matrix3d linear, AccessorFloatData data, int i) {
        Vec3 normal = new Vec3(data.get(i, 0), data.get(i, 1), data.get(i, 2));
        double squared = normal.toVector().lengthSquared();
        return squared > 0 && Double.isFinite(squared) ? Normals.transformed(linear, normal) : Vec3.ZERO;
    }

    /** Adds texture coordinates; glTF's origin is the top of the image, the mesh's the bottom. */
    private void addTexture(AccessorModel texture, int count) {
        AccessorData data = texture == null ? null : texture.getAccessorData();
        for (int i = 0; i < count; i++) {
            addCoordinate(textureCoordinates, data == null ? 0 : share(data, i, 0));
            addCoordinate(textureCoordinates, data == null ? 0 : 1 - share(data, i, 1));
        }
    }

    private void addCoordinate(FloatList list, double value) {
        if (!(Math.abs(value) <= MeshLimits.MAX_COORDINATE_UNITS)) {
            throw wrong(NumberFormatting.of(value) + " in a buffer is no coordinate", "keep within a million units");
        }
        list.add(value + 0.0);
    }

    private static double share(AccessorData data, int i, int component) {
        if (data instanceof AccessorFloatData floats) {
            return floats.get(i, component);
        }
        return data instanceof AccessorByteData bytes
                ? bytes.getInt(i, component) / BYTE_RANGE
                : ((AccessorShortData) data).getInt(i, component) / SHORT_RANGE;
    }

    private int[] corners(AccessorModel listed, int vertices) {
        int[] corners = new int[listed == null ? vertices : listed.getCount()];
        AccessorData data = listed == null ? null : listed.getAccessorData();
        for (int i = 0; i < corners.length; i++) {
            long corner = data == null ? i : index(data, i);
            if (corner >= vertices) {
                throw wrong(
                        "index " + corner + " in a buffer names no vertex; there are " + vertices,
                        "export the mesh again");
            }
            corners[i] = (int) corner;
        }
        return corners;
    }

    private static long index(AccessorData data, int i) {
        if (data instanceof AccessorIntData ints) {
            return ints.getLong(i);
        }
        return data instanceof AccessorShortData shorts ? shorts.getInt(i) : ((AccessorByteData) data).getInt(i);
    }

    private ModelFileException wrong(String reason, String remedy) {
        return new ModelFileException(file, 0, reason, remedy);
    }
}
