package nephele.engine.model;

import static org.junit.jupiter.api.Assertions.assertEquals;

import nephele.engine.model.shape.BoxShape;
import nephele.engine.model.shape.ConeShape;
import nephele.engine.model.shape.PlaneShape;
import nephele.engine.model.shape.SphereShape;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The diagonals and the start of the slices match the lines in the course's own pictures. */
class WireLinesTest {
    private static boolean hasLine(Mesh mesh, Vector3d a, Vector3d b) {
        for (int i = 0; i < mesh.indices().length; i++) {
            Vector3d from = Triangles.position(mesh, mesh.indices()[i]);
            Vector3d to = Triangles.position(mesh, mesh.indices()[i % 3 == 2 ? i - 2 : i + 1]);
            if (from.distance(a) < 1e-6 && to.distance(b) < 1e-6 || from.distance(b) < 1e-6 && to.distance(a) < 1e-6) {
                return true;
            }
        }
        return false;
    }

    @Test
    void aPlanesDiagonalsGoFromMinusXMinusZToPlusXPlusZ() {
        Mesh mesh = new PlaneShape(2, 1, false).mesh();
        assertEquals(true, hasLine(mesh, new Vector3d(-1, 0, -1), new Vector3d(1, 0, 1)));
    }

    @ParameterizedTest
    @CsvSource({
        "-1, 1, -1, 1, 1, 1",
        "-1, -1, 1, 1, 1, 1",
        "-1, -1, -1, 1, 1, -1",
        "1, -1, 1, 1, 1, -1",
        "-1, -1, -1, -1, 1, 1"
    })
    void aBoxsDiagonals(double ax, double ay, double az, double bx, double by, double bz) {
        assertEquals(true, hasLine(new BoxShape(2, 1).mesh(), new Vector3d(ax, ay, az), new Vector3d(bx, by, bz)));
    }

    @Test
    void aSpheresSlicesBeginAtPlusZAndItsDiagonalsFall() {
        Mesh mesh = new SphereShape(1, 10, 10).mesh();
        Vector3d lower = onSphere(1, 4);
        assertEquals(true, hasLine(mesh, lower, onSphere(0, 5)));
        assertEquals(false, hasLine(mesh, onSphere(0, 4), onSphere(1, 5)));
    }

    private static Vector3d onSphere(int slice, int stack) {
        double around = 2 * Math.PI * slice / 10;
        double up = Math.PI * stack / 10 - Math.PI / 2;
        return new Vector3d(Math.cos(up) * Math.sin(around), Math.sin(up), Math.cos(up) * Math.cos(around));
    }

    @Test
    void aConesSlicesBeginAtPlusZAndItsDiagonalsFall() {
        Mesh mesh = new ConeShape(1, 3, 4, 3).mesh();
        assertEquals(true, hasLine(mesh, new Vector3d(1, 0, 0), new Vector3d(0, 1, 2 / 3.0)));
        assertEquals(true, hasLine(mesh, new Vector3d(), new Vector3d(0, 0, 1)));
    }
}
