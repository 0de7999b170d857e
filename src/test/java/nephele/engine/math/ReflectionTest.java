package nephele.engine.math;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/** Tests the mirror image of points and directions at a plane. */
class ReflectionTest {
    private static final Vec3 NORMAL = new Vec3(2 / 7.0, 3 / 7.0, 6 / 7.0);

    /**
     * Applied twice it is the identity; the midpoint of a point and its image is on the plane, even 1000 km from the
     * origin.
     */
    @Test
    void pointsGoAsFarBehindThePlaneAsTheyWereBeforeIt() {
        for (double away : new double[] {0, 1, 1e6}) {
            Vec3 place = new Vec3(away, -away, 0.5 * away);
            var reflection = new Reflection(place, NORMAL);
            Vector3d p = new Vector3d(away + 1.25, -away + 2.5, 0.5 * away - 0.75);
            Vector3d image = reflection.point(new Vector3d(p));
            double before = new Vector3d(p).sub(place.toVector()).dot(NORMAL.toVector());
            double behind = new Vector3d(image).sub(place.toVector()).dot(NORMAL.toVector());
            double rounding = 1e-15 * (1 + away);
            assertEquals(before, -behind, rounding);
            assertEquals(2 * Math.abs(before), p.distance(image), rounding);
            assertEquals(0, reflection.point(new Vector3d(image)).distance(p), rounding);
        }
    }

    /** Lengths and angles are kept, handedness is reversed. */
    @Test
    void handednessChanges() {
        var reflection = new Reflection(new Vec3(5, 6, 7), NORMAL);
        Vector3d x = reflection.direction(new Vector3d(1, 0, 0));
        Vector3d y = reflection.direction(new Vector3d(0, 1, 0));
        Vector3d z = reflection.direction(new Vector3d(0, 0, 1));
        assertEquals(1, x.length(), 1e-15);
        assertEquals(0, x.dot(y), 1e-15);
        assertEquals(-1, x.cross(y).dot(z), 1e-15);
    }
}
