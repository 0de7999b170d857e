package nephele.workshop.art;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Base64;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import nephele.engine.cloud.ExtinctionField;
import nephele.engine.cloud.field.CloudFields;
import nephele.engine.level.Cloud;
import nephele.engine.level.CloudProfile;
import nephele.engine.level.CloudTechnique;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;

/**
 * The files of sample levels that are no pictures: a vase as OBJ and a knot as glTF for the level of models, a grid of
 * densities for that of grids.
 */
final class SampleFiles {
    private static final int KNOT_STEPS = 160;
    private static final int KNOT_SIDES = 12;
    private static final double KNOT_TUBE_METRES = 0.13;

    private static final int VASE_SLICES = 32;

    /** Height and radius of the vase in metres, from the middle of its foot to the inside of its neck. */
    private static final double[][] VASE = {
        {0, 0},
        {0, 0.16},
        {0.03, 0.17},
        {0.1, 0.2},
        {0.22, 0.27},
        {0.36, 0.31},
        {0.5, 0.29},
        {0.62, 0.21},
        {0.7, 0.15},
        {0.78, 0.13},
        {0.86, 0.15},
        {0.9, 0.19},
        {0.9, 0.17},
        {0.84, 0.12},
        {0.76, 0.1},
        {0.6, 0.1}
    };

    private static final int GRID_WIDE = 44;
    private static final int GRID_HIGH = 28;
    private static final float GRID_WIDE_METRES = 1100;
    private static final float GRID_HIGH_METRES = 700;

    private SampleFiles() {}

    /** Returns the files by asset id. */
    static Map<String, byte[]> all() {
        Map<String, byte[]> files = new LinkedHashMap<>();
        files.put("models/vase.obj", vase().getBytes(StandardCharsets.UTF_8));
        files.put("models/knot.gltf", knot().getBytes(StandardCharsets.UTF_8));
        files.put("clouds/heap.vol", grid());
        return files;
    }

    /** Returns an OBJ file without normals; the reader generates smooth ones. */
    private static String vase() {
        StringBuilder obj = new StringBuilder("# A vase, turned from its profile; 0.9 m high.\n");
        int rows = VASE.length;
        for (double[] ring : VASE) {
            for (int slice = 0; slice < VASE_SLICES; slice++) {
                double angle = 2 * Math.PI * slice / VASE_SLICES;
                line(obj, "v", ring[1] * StrictMath.sin(angle), ring[0], ring[1] * StrictMath.cos(angle));
            }
        }
        for (int row = 0; row < rows; row++) {
            for (int slice = 0; slice <= VASE_SLICES; slice++) {
                line(obj, "vt", (double) slice / VASE_SLICES, (double) row / (rows - 1));
            }
        }
        for (int row = 0; row + 1 < rows; row++) {
            for (int slice = 0; slice < VASE_SLICES; slice++) {
                obj.append('f');
                corner(obj, row, slice);
                corner(obj, row, slice + 1);
                if (row > 0) {
                    corner(obj, row + 1, slice + 1);
                    corner(obj, row + 1, slice);
                } else {
                    corner(obj, 1, slice);
                }
                obj.append('\n');
            }
        }
        return obj.toString().replace("-0.00000", "0.00000");
    }

    private static void line(StringBuilder obj, String kind, double... numbers) {
        obj.append(kind);
        for (double number : numbers) {
            obj.append(String.format(Locale.ROOT, " %.5f", number));
        }
        obj.append('\n');
    }

    private static void corner(StringBuilder obj, int row, int slice) {
        int position = row * VASE_SLICES + slice % VASE_SLICES + 1;
        int texture = row * (VASE_SLICES + 1) + slice + 1;
        obj.append(' ').append(position).append('/').append(texture);
    }

    /** Returns a point of a trefoil knot around the y axis. */
    private static Vector3d trefoil(double turn) {
        double radius = 0.42 + 0.2 * StrictMath.cos(3 * turn);
        return new Vector3d(
                radius * StrictMath.cos(2 * turn), 0.28 * StrictMath.sin(3 * turn), radius * StrictMath.sin(2 * turn));
    }

    private static String knot() {
        int vertices = (KNOT_STEPS + 1) * (KNOT_SIDES + 1);
        int triangles = 2 * KNOT_STEPS * KNOT_SIDES;
        ByteBuffer bytes = ByteBuffer.allocate(32 * vertices + 6 * triangles).order(ByteOrder.LITTLE_ENDIAN);
        Vector3d least = new Vector3d(Double.POSITIVE_INFINITY);
        Vector3d most = new Vector3d(Double.NEGATIVE_INFINITY);
        for (int i = 0; i < vertices; i++) {
            Vector3d p = knotNormal(i).mul(KNOT_TUBE_METRES).add(trefoil(turn(i)));
            least.min(p);
            most.max(p);
            put(bytes, p);
        }
        for (int i = 0; i < vertices; i++) {
            put(bytes, knotNormal(i));
        }
        for (int i = 0; i < vertices; i++) {
            bytes.putFloat(16f * (i / (KNOT_SIDES + 1)) / KNOT_STEPS);
            bytes.putFloat((float) (i % (KNOT_SIDES + 1)) / KNOT_SIDES);
        }
        for (int step = 0; step < KNOT_STEPS; step++) {
            for (int side = 0; side < KNOT_SIDES; side++) {
                int a = step * (KNOT_SIDES + 1) + side;
                int b = a + KNOT_SIDES + 1;
                for (int corner : new int[] {a, b, b + 1, a, b + 1, a + 1}) {
                    bytes.putShort((short) corner);
                }
            }
        }
        return json(vertices, 3 * triangles, bytes.array(), floats(least), floats(most));
    }

    private static double turn(int vertex) {
        return 2 * Math.PI * (vertex / (KNOT_SIDES + 1) % KNOT_STEPS) / KNOT_STEPS;
    }

    /** Returns the outward normal of the tube, in the plane of its cross section. */
    private static Vector3d knotNormal(int vertex) {
        double turn = turn(vertex);
        Vector3d along = trefoil(turn + 1e-4).sub(trefoil(turn - 1e-4)).normalize();
        Vector3d up = new Vector3d(0, 1, 0);
        Vector3d across = along.cross(up, new Vector3d()).normalize();
        across.cross(along, up);
        double angle = 2 * Math.PI * (vertex % (KNOT_SIDES + 1) % KNOT_SIDES) / KNOT_SIDES;
        return across.mul(StrictMath.cos(angle)).fma(StrictMath.sin(angle), up).normalize();
    }

    private static void put(ByteBuffer bytes, Vector3d v) {
        bytes.putFloat((float) v.x).putFloat((float) v.y).putFloat((float) v.z);
    }

    private static String floats(Vector3d v) {
        return String.format(Locale.ROOT, "[%.9g, %.9g, %.9g]", (float) v.x, (float) v.y, (float) v.z);
    }

    private static String json(int vertices, int indices, byte[] bytes, String least, String most) {
        String view = "    {\"buffer\": 0, \"byteOffset\": %d, \"byteLength\": %d},\n";
        String accessor =
                "    {\"bufferView\": %d, \"componentType\": 5126, \"count\": " + vertices + ", \"type\": \"%s\"%s},\n";
        return "{\n  \"asset\": {\"version\": \"2.0\"},\n  \"scene\": 0,\n  \"scenes\": [{\"nodes\": [0]}],\n"
                + "  \"nodes\": [{\"mesh\": 0}],\n"
                + "  \"meshes\": [{\"primitives\": [{\"attributes\":"
                + " {\"POSITION\": 0, \"NORMAL\": 1, \"TEXCOORD_0\": 2}, \"indices\": 3}]}],\n"
                + "  \"accessors\": [\n"
                + accessor.formatted(0, "VEC3", ", \"min\": " + least + ", \"max\": " + most)
                + accessor.formatted(1, "VEC3", "")
                + accessor.formatted(2, "VEC2", "")
                + "    {\"bufferView\": 3, \"componentType\": 5123, \"count\": " + indices
                + ", \"type\": \"SCALAR\"}\n  ],\n  \"bufferViews\": [\n"
                + view.formatted(0, 12 * vertices)
                + view.formatted(12 * vertices, 12 * vertices)
                + view.formatted(24 * vertices, 8 * vertices)
                + "    {\"buffer\": 0, \"byteOffset\": " + 32 * vertices + ", \"byteLength\": " + 2 * indices + "}\n"
                + "  ],\n  \"buffers\": [{\"byteLength\": " + bytes.length
                + ", \"uri\": \"data:application/octet-stream;base64,"
                + Base64.getEncoder().encodeToString(bytes) + "\"}]\n}\n";
    }

    /** Returns one heap of noise, taken at the centres of voxels, in Mitsuba's grid volume format, version 3, of 32-bit floats. */
    private static byte[] grid() {
        ByteBuffer file =
                ByteBuffer.allocate(48 + 4 * GRID_WIDE * GRID_HIGH * GRID_WIDE).order(ByteOrder.LITTLE_ENDIAN);
        file.put(new byte[] {'V', 'O', 'L', 3});
        file.putInt(1).putInt(GRID_WIDE).putInt(GRID_HIGH).putInt(GRID_WIDE).putInt(1);
        file.putFloat(-GRID_WIDE_METRES / 2).putFloat(-GRID_HIGH_METRES / 2).putFloat(-GRID_WIDE_METRES / 2);
        file.putFloat(GRID_WIDE_METRES / 2).putFloat(GRID_HIGH_METRES / 2).putFloat(GRID_WIDE_METRES / 2);
        ExtinctionField heap = heap();
        for (int k = 0; k < GRID_WIDE; k++) {
            for (int j = 0; j < GRID_HIGH; j++) {
                for (int i = 0; i < GRID_WIDE; i++) {
                    file.putFloat((float) heap.perMetre(at(i, GRID_WIDE), at(j, GRID_HIGH), at(k, GRID_WIDE)));
                }
            }
        }
        return file.array();
    }

    /** Returns a field whose extinction is the density, in the box of −1 to 1. */
    private static ExtinctionField heap() {
        var noise = new Cloud.Density.Noise(11, 0.55, 1, 0.4, CloudProfile.CUMULUS, null, 0);
        var extent = new Cloud.Extent.Volume(Vec3.ZERO, new Vec3(2, 2, 2));
        return CloudFields.of(new Cloud("heap", extent, CloudTechnique.AUTO, noise, 1, 1, 0), null, 0);
    }

    private static double at(int voxel, int voxels) {
        return (2 * voxel + 1.0) / voxels - 1;
    }
}
