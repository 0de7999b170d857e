package nephele.engine.scene.light;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/** The share of a sphere equals quadrature over the hemisphere where it is above the horizon, and nearly where it dips below. */
class ContactShareTest {
    private static final Vector3d UP = new Vector3d(0, 1, 0);
    private static final int CELLS = 400;

    /** Sums over equal areas of the unit disc, which are equal parts of the cosine-weighted hemisphere. */
    private static double quadrature(Vector3d centre, double radius) {
        int hidden = 0;
        int all = 0;
        for (int i = 0; i < CELLS; i++) {
            for (int j = 0; j < CELLS; j++) {
                double x = (2 * i + 1.0) / CELLS - 1;
                double z = (2 * j + 1.0) / CELLS - 1;
                double y = 1 - x * x - z * z;
                if (y > 0) {
                    double along = centre.dot(x, Math.sqrt(y), z);
                    all++;
                    hidden += along > 0 && centre.lengthSquared() - along * along < radius * radius ? 1 : 0;
                }
            }
        }
        return (double) hidden / all;
    }

    private static Vector3d at(double x, double y) {
        return new Vector3d(x, y, 0);
    }

    @Test
    void aboveTheHorizonItIsExact() {
        SplittableRandom random = new SplittableRandom(1);
        for (int i = 0; i < 20; i++) {
            double radius = 0.1 + random.nextDouble();
            Vector3d centre = at(3 * random.nextDouble(), radius * (1 + random.nextDouble()));
            assertEquals(quadrature(centre, radius), ContactShare.ofSphere(centre, radius, UP), 2e-3, "" + centre);
        }
    }

    @Test
    void belowTheHorizonItIsNearlyExactUnlessItTouches() {
        SplittableRandom random = new SplittableRandom(2);
        for (int i = 0; i < 20; i++) {
            Vector3d centre = at(1.2 + 2 * random.nextDouble(), 2 * random.nextDouble() - 1);
            assertEquals(quadrature(centre, 1), ContactShare.ofSphere(centre, 1, UP), 0.04, "" + centre);
        }
        // Half of the sphere is above the horizon.
        assertEquals(quadrature(at(2, 0), 1), ContactShare.ofSphere(at(2, 0), 1, UP), 0.01);
    }

    @Test
    void extremesStayWithinNothingAndAll() {
        assertEquals(1, ContactShare.ofSphere(at(0, 1), 1, UP), 1e-12, "a sphere that rests on the surface");
        assertEquals(0, ContactShare.ofSphere(at(0, -1), 1, UP), 1e-12, "a sphere that touches from behind");
        assertEquals(0, ContactShare.ofSphere(at(0, -3), 1, UP), 1e-12, "a sphere behind the surface");
        assertEquals(0, ContactShare.ofSphere(at(1, 1), 1e-9, UP), 1e-12, "a point");
        assertEquals(1e-10, ContactShare.ofSphere(at(0, 1e5), 1, UP), 1e-13, "a sphere far away");
        for (double height = -1; height <= 1; height += 0.125) {
            double inside = ContactShare.ofSphere(at(0, height), 1, UP);
            assertTrue(inside >= 0 && inside <= 1, "inside, " + height + " above: " + inside);
        }
    }
}
