package nephele.engine.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.function.BinaryOperator;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import nephele.engine.model.shape.BoxShape;
import nephele.engine.model.shape.ConeShape;
import nephele.engine.model.shape.CylinderShape;
import nephele.engine.model.shape.PlaneShape;
import nephele.engine.model.shape.Shape;
import nephele.engine.model.shape.SphereShape;
import nephele.engine.model.shape.TorusShape;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Compares the normals of every primitive at many numbers of divisions with the analytic normals of the surface. */
@Execution(ExecutionMode.CONCURRENT)
class ShapeNormalsTest {
    /** Each small number, at which slices have the greatest angles, then some of every size, odd and even. */
    private static final int[] DIVISIONS = IntStream.concat(
                    IntStream.rangeClosed(1, 32), IntStream.of(47, 64, 99, 128, 199, 256))
            .toArray();

    private static final double RADIUS = 1.5;
    private static final double HEIGHT = 2.5;
    private static final double TUBE = 0.4;

    /**
     * A surface to test.
     *
     * @param at creates the shape with a number of divisions
     * @param analytic returns the surface's normal at a position; at an edge the mesh's normal selects the face
     */
    private record Surface(String name, IntFunction<Shape> at, BinaryOperator<Vector3d> analytic) {
        @Override
        public String toString() {
            return name;
        }
    }

    private static Stream<Surface> surfaces() {
        return Stream.of(
                new Surface("plane", n -> new PlaneShape(2, n, false), (p, n) -> new Vector3d(0, 1, 0)),
                new Surface("two sides", n -> new PlaneShape(2, n, true), (p, n) -> new Vector3d(0, flat(n.y), 0)),
                new Surface("box", n -> new BoxShape(2, n), ShapeNormalsTest::ofBox),
                new Surface("sphere", n -> new SphereShape(RADIUS, slices(n), Math.max(n, 2)), (p, n) -> p.div(RADIUS)),
                new Surface("cone", n -> new ConeShape(RADIUS, HEIGHT, slices(n), n), ShapeNormalsTest::ofCone),
                new Surface(
                        "cylinder", n -> new CylinderShape(RADIUS, HEIGHT, slices(n)), ShapeNormalsTest::ofCylinder),
                new Surface(
                        "torus", n -> new TorusShape(RADIUS, TUBE, slices(n), slices(n)), ShapeNormalsTest::ofTorus));
    }

    private static int slices(int divisions) {
        return Math.max(divisions, 3);
    }

    private static double flat(double normal) {
        return normal < 0 ? -1 : 1;
    }

    private static Vector3d ofBox(Vector3d position, Vector3d normal) {
        int axis = normal.maxComponent();
        assertEquals(Math.signum(normal.get(axis)), position.get(axis), 1e-6, "the vertex lies on its face");
        return new Vector3d().setComponent(axis, Math.signum(normal.get(axis)));
    }

    private static Vector3d ofCone(Vector3d p, Vector3d normal) {
        if (normal.y < 0) {
            assertEquals(0, p.y, 0);
            return new Vector3d(0, -1, 0);
        }
        boolean tip = p.y == (float) HEIGHT;
        double angle = tip ? Math.atan2(normal.x, normal.z) : Math.atan2(p.x, p.z);
        double length = Math.sqrt(RADIUS * RADIUS + HEIGHT * HEIGHT);
        return new Vector3d(HEIGHT * Math.sin(angle), RADIUS, HEIGHT * Math.cos(angle)).div(length);
    }

    private static Vector3d ofCylinder(Vector3d p, Vector3d normal) {
        if (Math.abs(normal.y) > 0.5) {
            assertEquals(flat(normal.y) * HEIGHT / 2, p.y, 1e-6);
            return new Vector3d(0, flat(normal.y), 0);
        }
        return new Vector3d(p.x, 0, p.z).div(RADIUS);
    }

    private static Vector3d ofTorus(Vector3d p, Vector3d normal) {
        Vector3d middle = new Vector3d(p.x, 0, p.z).normalize(RADIUS);
        return p.sub(middle).div(TUBE);
    }

    @ParameterizedTest
    @MethodSource("surfaces")
    void normalsAreTheSurfacesOwnAtEveryVertexOf1To256Divisions(Surface surface) {
        double worst = 0;
        double longest = 0;
        for (int divisions : DIVISIONS) {
            Mesh mesh = surface.at.apply(divisions).mesh();
            for (int i = 0; i < mesh.vertexCount(); i++) {
                Vector3d normal = Triangles.vertexNormal(mesh, i);
                longest = Math.max(longest, Math.abs(normal.length() - 1));
                Vector3d wanted = surface.analytic.apply(Triangles.position(mesh, i), new Vector3d(normal));
                worst = Math.max(worst, wanted.distance(normal));
            }
        }
        assertTrue(worst <= 1e-5, "off by " + worst);
        assertTrue(longest <= 1e-6, "off unit length by " + longest);
    }

    /** Every triangle faces the side of its vertex normals; as these are the surface's, it is wound outward. */
    @ParameterizedTest
    @MethodSource("surfaces")
    void trianglesFaceWhereTheirVerticesDo(Surface surface) {
        for (int divisions : List.of(1, 2, 3, 4, 5, 7, 16, 33, 100, 256)) {
            Mesh mesh = surface.at.apply(divisions).mesh();
            for (int i = 0; i < mesh.indices().length; i++) {
                double along = Triangles.normal(mesh, i - i % 3).dot(Triangles.vertexNormal(mesh, mesh.indices()[i]));
                assertTrue(along > 0, divisions + " divisions, corner " + i);
            }
        }
    }

    /**
     * A cone's normal is (h cos t, r, h sin t) / √(r² + h²); halfway up a cone of r = 1, h = 2 it is 26.6° above the
     * horizontal.
     */
    @Test
    void aConesNormalsHaveItsSlopeAndTheTipOnePerSlice() {
        Mesh mesh = new ConeShape(1, 2, 4, 3).mesh();
        double height = Math.sin(Math.toRadians(26.565051177));
        int tips = 0;
        for (int i = 0; i < mesh.vertexCount(); i++) {
            Vector3d normal = Triangles.vertexNormal(mesh, i);
            boolean base = normal.y < 0;
            assertEquals(base ? -1 : height, normal.y, 1e-6);
            if (mesh.positions()[3 * i + 1] == 2) {
                assertEquals(Math.abs(normal.x), Math.abs(normal.z), 1e-6, "faces along the middle of a slice");
                tips++;
            }
        }
        assertEquals(4, tips);
    }

    /** At the poles the normal is the axis. */
    @Test
    void aSpheresPolesFaceAlongItsAxis() {
        Mesh mesh = new SphereShape(3, 7, 5).mesh();
        for (int i = 0; i < 7; i++) {
            assertEquals(new Vector3d(0, -1, 0), Triangles.vertexNormal(mesh, i));
            assertEquals(new Vector3d(0, 1, 0), Triangles.vertexNormal(mesh, mesh.vertexCount() - 1 - i));
        }
    }
}
