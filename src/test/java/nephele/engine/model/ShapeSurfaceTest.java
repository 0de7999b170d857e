package nephele.engine.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.Stream;
import nephele.engine.model.shape.BoxShape;
import nephele.engine.model.shape.ConeShape;
import nephele.engine.model.shape.CylinderShape;
import nephele.engine.model.shape.PlaneShape;
import nephele.engine.model.shape.Shape;
import nephele.engine.model.shape.ShapeKind;
import nephele.engine.model.shape.SphereShape;
import nephele.engine.model.shape.TorusShape;
import org.joml.Vector2d;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the positions and texture coordinates of primitives, and the ranges of their parameters. */
class ShapeSurfaceTest {
    private static Stream<Shape> closed() {
        return Stream.of(
                new BoxShape(2, 1),
                new BoxShape(0.7, 3),
                new BoxShape(2, 17),
                new SphereShape(1, 3, 2),
                new SphereShape(1, 10, 10),
                new SphereShape(0.3, 31, 17),
                new ConeShape(1, 2, 3, 1),
                new ConeShape(1, 2, 4, 3),
                new ConeShape(0.3, 0.7, 29, 11),
                new CylinderShape(1, 2, 3),
                new CylinderShape(0.3, 0.7, 29),
                new TorusShape(1, 0.25, 3, 3),
                new TorusShape(1, 0.3, 31, 17));
    }

    private static Stream<Shape> all() {
        return Stream.concat(closed(), Stream.of(new PlaneShape(2, 3, false), new PlaneShape(2, 4, true)));
    }

    @ParameterizedTest
    @MethodSource("closed")
    void noGapIsBetweenTriangles(Shape shape) {
        assertEquals(0, EdgeCount.open(shape.mesh()));
    }

    @Test
    void volumesAreThoseOfTheSolids() {
        assertEquals(8, volume(new BoxShape(2, 5).mesh()), 1e-6);
        assertEquals(4 / 3.0 * Math.PI, volume(new SphereShape(1, 256, 256).mesh()), 1e-3);
        assertEquals(2 / 3.0 * Math.PI, volume(new ConeShape(1, 2, 512, 2).mesh()), 1e-3);
        assertEquals(2 * Math.PI, volume(new CylinderShape(1, 2, 512).mesh()), 1e-3);
        assertEquals(2 * Math.PI * Math.PI * 0.25, volume(new TorusShape(1, 0.5, 256, 256).mesh()), 2e-3);
    }

    private static double volume(Mesh mesh) {
        double sum = 0;
        for (int i = 0; i < mesh.indices().length; i += 3) {
            sum += Triangles.normal(mesh, i).dot(Triangles.position(mesh, mesh.indices()[i])) / 6;
        }
        return sum;
    }

    /** Chords are within r (1 - cos(π / n)) of the circle, and this maximum is reached in the middle of a slice. */
    @ParameterizedTest
    @ValueSource(ints = {3, 4, 5, 8, 31, 100, 511, 512})
    void theSagittaOfASliceIsThatOfAChord(int slices) {
        Mesh mesh = new CylinderShape(2, 1, slices).mesh();
        double sagitta = 0;
        for (int i = 0; i < slices; i++) {
            Vector3d middle = Triangles.position(mesh, i)
                    .add(Triangles.position(mesh, i + 1))
                    .mul(0.5);
            sagitta = Math.max(sagitta, 2 - Math.hypot(middle.x, middle.z));
        }
        assertEquals(2 * (1 - Math.cos(Math.PI / slices)), sagitta, 1e-6);
    }

    @ParameterizedTest
    @MethodSource("all")
    void picturesAreNowhereMirroredAndWithinTheirEdges(Shape shape) {
        Mesh mesh = shape.mesh();
        for (float coordinate : mesh.textureCoordinates()) {
            assertTrue(coordinate >= 0 && coordinate <= 1);
        }
        for (int i = 0; i < mesh.indices().length; i += 3) {
            Vector2d a = texture(mesh, i);
            Vector2d ab = texture(mesh, i + 1).sub(a);
            Vector2d ac = texture(mesh, i + 2).sub(a);
            assertTrue(ab.x * ac.y - ab.y * ac.x > 0, "triangle " + i / 3);
        }
    }

    /**
     * On every non-horizontal triangle t grows with y; on a torus only outside, because the image wraps around its
     * tube.
     */
    @ParameterizedTest
    @MethodSource("closed")
    void picturesStandUpright(Shape shape) {
        Mesh mesh = shape.mesh();
        for (int i = 0; i < mesh.indices().length; i += 3) {
            Vector3d normal = Triangles.normal(mesh, i).normalize();
            Vector3d place = Triangles.position(mesh, mesh.indices()[i]);
            boolean inside = shape instanceof TorusShape && normal.x * place.x + normal.z * place.z < 0.1;
            if (Math.abs(normal.y) < 0.99 && !inside) {
                assertTrue(riseOfPicture(mesh, i) > 0, "triangle " + i / 3);
            }
        }
    }

    /** Returns the y component of the direction in which t grows at constant s, on a triangle. */
    private static double riseOfPicture(Mesh mesh, int first) {
        Vector2d a = texture(mesh, first);
        Vector2d ab = texture(mesh, first + 1).sub(a);
        Vector2d ac = texture(mesh, first + 2).sub(a);
        double ay = Triangles.position(mesh, mesh.indices()[first]).y;
        double by = Triangles.position(mesh, mesh.indices()[first + 1]).y - ay;
        double cy = Triangles.position(mesh, mesh.indices()[first + 2]).y - ay;
        return (ab.x * cy - ac.x * by) / (ab.x * ac.y - ab.y * ac.x);
    }

    private static Vector2d texture(Mesh mesh, int corner) {
        int vertex = mesh.indices()[corner];
        return new Vector2d(mesh.textureCoordinates()[2 * vertex], mesh.textureCoordinates()[2 * vertex + 1]);
    }

    @Test
    void everyFaceOfABoxShowsThePictureWhole() {
        Mesh mesh = new BoxShape(2, 3).mesh();
        int perFace = mesh.vertexCount() / 6;
        for (int face = 0; face < 6; face++) {
            assertEquals(0, mesh.textureCoordinates()[2 * face * perFace]);
            assertEquals(0, mesh.textureCoordinates()[2 * face * perFace + 1]);
            assertEquals(1, mesh.textureCoordinates()[2 * (face * perFace + perFace - 1)]);
            assertEquals(1, mesh.textureCoordinates()[2 * (face * perFace + perFace - 1) + 1]);
        }
    }

    @Test
    void aPlanesCornersAreThePictures() {
        Mesh mesh = new PlaneShape(2, 3, false).mesh();
        assertEquals(new Vector3d(-1, 0, 1), Triangles.position(mesh, 0));
        assertEquals(new Vector2d(0, 0), texture(mesh, 0));
        assertEquals(new Vector3d(1, 0, -1), Triangles.position(mesh, mesh.vertexCount() - 1));
        assertEquals(1, mesh.textureCoordinates()[2 * mesh.vertexCount() - 1]);
    }

    /** The seam is stored twice, with the left and the right edge of the image. */
    @Test
    void aSpheresSeamIsDoubled() {
        Mesh mesh = new SphereShape(1, 8, 8).mesh();
        int left = 8;
        int right = left + 8;
        assertEquals(Triangles.position(mesh, left), Triangles.position(mesh, right));
        assertEquals(0, mesh.textureCoordinates()[2 * left]);
        assertEquals(1, mesh.textureCoordinates()[2 * right]);
    }

    /**
     * A radius or height of 0, NaN, infinities, and 0 or 10⁶ divisions are rejected with a message that names the
     * number.
     */
    @ParameterizedTest
    @ValueSource(
            strings = {
                "plane 0 1 LENGTH", "plane -1 1 LENGTH", "plane 1 0 DIVISIONS", "plane 1 513 DIVISIONS",
                "plane 1 1000000 DIVISIONS", "plane 1e300 1 LENGTH", "plane NaN 1 LENGTH", "plane 1e999 1 LENGTH",
                "plane 1 2.5 DIVISIONS", "box 1 -3 DIVISIONS", "box 0x1p3 1 LENGTH", "box 1f 1 LENGTH",
                "box 1 2,5 DIVISIONS", "cone 0 1 4 4 RADIUS", "cone 1 0 4 4 HEIGHT", "cone 1 1 2 4 SLICES",
                "cone 1 1 513 4 SLICES", "cone 1 1 4 0 STACKS", "sphere 1 2 4 SLICES", "sphere 1 4 1 STACKS",
                "sphere 1 4 513 STACKS", "sphere 0 4 4 RADIUS", "cylinder 1 0 4 HEIGHT", "cylinder 1 1 1000000 SLICES",
                "torus 1 1 8 8 TUBE", "torus 1 0 8 8 TUBE", "torus 1 0.5 8 2 STACKS", "torus 0 0.5 8 8 RADIUS",
                "plane 1 numbers", "box numbers", "torus 1 1 numbers"
            })
    void whatMakesNoShapeIsRefusedByName(String line) {
        var words = List.of(line.split(" "));
        var kind = ShapeKind.named(words.get(0)).orElseThrow();
        var problem =
                assertThrows(IllegalArgumentException.class, () -> kind.shape(words.subList(1, words.size() - 1)));
        assertTrue(problem.getMessage().contains(words.get(words.size() - 1)), problem.getMessage());
    }

    @Test
    void theMostPartsAreTaken() {
        assertEquals(2 * 512 * 511, new SphereShape(1, 512, 512).mesh().triangleCount());
        assertEquals(12 * 512 * 512, new BoxShape(1, 512).mesh().triangleCount());
    }
}
