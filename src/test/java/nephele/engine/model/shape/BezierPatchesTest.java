package nephele.engine.model.shape;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import nephele.engine.asset.ResourceAssets;
import nephele.engine.model.EdgeCount;
import nephele.engine.model.Mesh;
import nephele.engine.model.Triangles;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

@Execution(ExecutionMode.CONCURRENT)
class BezierPatchesTest {
    private final BezierPatches teapot =
            BezierPatches.read("teapot.patch", new ResourceAssets("/assets").bytes(BezierPatches.SHIPPED));

    /**
     * Normals are along the axis where the edges of four patches shrink to the tip of the knob or the middle of the
     * floor.
     */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 10, 31})
    void degenerateCornersOfTheTeapotFaceAlongItsAxis(int tessellation) {
        Mesh mesh = new BezierShape(teapot, tessellation).mesh();
        List<Vector3d> tip = new ArrayList<>();
        List<Vector3d> floor = new ArrayList<>();
        for (int i = 0; i < mesh.vertexCount(); i++) {
            Vector3d place = Triangles.position(mesh, i);
            if (Math.hypot(place.x, place.y) < 1e-9) {
                (place.z > 1 ? tip : floor).add(Triangles.vertexNormal(mesh, i));
            }
        }
        assertEquals(4 * (tessellation + 1), tip.size());
        assertEquals(4 * (tessellation + 1), floor.size());
        tip.forEach(normal -> assertTrue(normal.angle(new Vector3d(0, 0, 1)) < Math.toRadians(1)));
        tip.forEach(normal -> assertTrue(normal.distance(tip.get(0)) < 1e-5));
        floor.forEach(normal -> assertTrue(normal.angle(new Vector3d(0, 0, -1)) < Math.toRadians(1)));
        floor.forEach(normal -> assertTrue(normal.distance(floor.get(0)) < 1e-5));
    }

    /** The same holds for a degenerate edge on any side: the teapot with its patches rotated by quarters. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3})
    void degenerateEdgesFaceOutwardOnWhicheverSide(int quarters) {
        List<BezierPatch> turned = new ArrayList<>();
        for (BezierPatch patch : teapot.patches()) {
            Vector3d[] points = patch.points();
            for (int turn = 0; turn < quarters; turn++) {
                points = quarterTurned(points);
            }
            turned.add(new BezierPatch(points));
        }
        Mesh mesh = new BezierShape(new BezierPatches("turned.patch", turned), 4).mesh();
        for (int i = 0; i < mesh.vertexCount(); i++) {
            Vector3d place = Triangles.position(mesh, i);
            if (Math.hypot(place.x, place.y) < 1e-9) {
                Vector3d axis = new Vector3d(0, 0, place.z > 1 ? 1 : -1);
                assertTrue(Triangles.vertexNormal(mesh, i).distance(axis) < 1e-5);
            }
        }
    }

    /** Turns rows into columns, and the last row into the first column; the orientation stays. */
    private static Vector3d[] quarterTurned(Vector3d[] points) {
        Vector3d[] turned = new Vector3d[points.length];
        for (int i = 0; i < points.length; i++) {
            turned[i] = points[4 * (3 - i % 4) + i / 4];
        }
        return turned;
    }

    /** Vertex normals are of unit length and on the front side of their triangles, at every tessellation. */
    @Test
    void normalsAreUnitAndFaceAsTheTrianglesDo() {
        for (int tessellation : new int[] {1, 3, 10, 64, 256}) {
            Mesh mesh = new BezierShape(teapot, tessellation).mesh();
            for (int i = 0; i < mesh.vertexCount(); i++) {
                assertEquals(1, Triangles.vertexNormal(mesh, i).length(), 1e-6);
            }
            if (tessellation >= 10) {
                assertEquals(0, againstTheirTriangle(mesh), "tessellation " + tessellation);
            }
        }
    }

    private static int againstTheirTriangle(Mesh mesh) {
        int against = 0;
        for (int i = 0; i < mesh.indices().length; i++) {
            Vector3d normal = Triangles.vertexNormal(mesh, mesh.indices()[i]);
            against += Triangles.normal(mesh, i - i % 3).dot(normal) <= 0 ? 1 : 0;
        }
        return against;
    }

    /**
     * The normal of the saddle z = u v over the unit square is (-v, -u, 1) / √(1 + u² + v²), with the sign of the
     * patches' orientation.
     */
    @Test
    void normalsAreAnalytic() {
        var text = new StringBuilder("1\n0,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15\n16\n");
        for (int row = 0; row < 4; row++) {
            for (int column = 0; column < 4; column++) {
                double u = column / 3.0;
                double v = row / 3.0;
                text.append(u + ", " + v + ", " + u * v + "\n");
            }
        }
        BezierPatches saddle = BezierPatches.read("a.patch", text.toString().getBytes(StandardCharsets.UTF_8));
        for (int tessellation = 1; tessellation <= 256; tessellation++) {
            Mesh mesh = new BezierShape(saddle, tessellation).mesh();
            for (int i = 0; i < mesh.vertexCount(); i++) {
                Vector3d p = Triangles.position(mesh, i);
                Vector3d wanted = new Vector3d(-p.y, -p.x, 1).normalize();
                assertTrue(wanted.distance(Triangles.vertexNormal(mesh, i)) < 1e-5);
                assertEquals(p.x * p.y, p.z, 1e-6);
                assertEquals(1 - p.x, mesh.textureCoordinates()[2 * i], 1e-6);
                assertEquals(1 - p.y, mesh.textureCoordinates()[2 * i + 1], 1e-6);
            }
        }
    }

    /** Only the rims of lid, body, handle and spout are open; joined patches have no gap, not even of the last bit. */
    @Test
    void patchesMeetWithoutAGap() {
        long coarse = EdgeCount.open(new BezierShape(teapot, 2).mesh());
        for (int parts : new int[] {5, 7, 10, 31}) {
            assertEquals(coarse * parts / 2, EdgeCount.open(new BezierShape(teapot, parts).mesh()), parts + " parts");
        }
    }

    @Test
    void aPatchThatIsALineOrAPointStillHasUnitNormals() {
        for (String point : new String[] {"1,2,3", "%d,0,0"}) {
            var text = new StringBuilder("1\n0,1,2,3,4,5,6,7,8,9,10,11,12,13,14,15\n16\n");
            for (int i = 0; i < 16; i++) {
                text.append(String.format(point, i)).append('\n');
            }
            Mesh mesh = new BezierShape(
                            BezierPatches.read("a.patch", text.toString().getBytes(StandardCharsets.UTF_8)), 4)
                    .mesh();
            for (int i = 0; i < mesh.vertexCount(); i++) {
                assertEquals(1, Triangles.vertexNormal(mesh, i).length(), 1e-6);
            }
        }
    }
}
