package nephele.engine.portal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.level.PortalShape;
import nephele.engine.math.Vec3;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/** The portal transform is rigid, and that of the partner is its inverse. */
final class PortalTransformTest {
    private static final Vec3 UP = new Vec3(0, 1, 0);

    private static Portal portal(Vec3 centre, Vec3 normal, Vec3 up) {
        return new Portal("p", centre, Portal.facing(normal, up), Aperture.of(PortalShape.ARCH, 1.2, 2.1));
    }

    private static Vec3 any(SplittableRandom random, double reach) {
        return new Vec3(
                random.nextDouble(-reach, reach), random.nextDouble(-reach, reach), random.nextDouble(-reach, reach));
    }

    private static void assertNear(Vec3 expected, Vec3 actual, double tolerance) {
        assertEquals(expected.x(), actual.x(), tolerance);
        assertEquals(expected.y(), actual.y(), tolerance);
        assertEquals(expected.z(), actual.z(), tolerance);
    }

    /** Through a wall that faces south and out of one that faces east, left stays left. */
    @Test
    void fromWallToWall() {
        Portal a = portal(new Vec3(1, 1, 0), new Vec3(0, 0, 1), UP);
        Portal b = portal(new Vec3(20, 3, 5), new Vec3(1, 0, 0), UP);
        PortalTransform transform = PortalTransform.between(a, b);
        assertNear(new Vec3(20, 3, 5), transform.point(new Vec3(1, 1, 0)), 1e-15);
        assertNear(new Vec3(1, 0, 0), transform.direction(new Vec3(0, 0, -1)), 1e-15);
        assertNear(new Vec3(0, 0, -1), transform.direction(new Vec3(-1, 0, 0)), 1e-15);
        assertNear(UP, transform.direction(UP), 1e-15);
        assertNear(new Vec3(22, 3.5, 5), transform.point(new Vec3(1, 1.5, -2)), 1e-15);
    }

    @Test
    void backToBackIsADoorway() {
        Portal a = portal(new Vec3(1, 1, 0), new Vec3(0, 0, 1), UP);
        Portal b = portal(new Vec3(1, 1, -0.2), new Vec3(0, 0, -1), UP);
        PortalTransform transform = PortalTransform.between(a, b);
        Vec3 v = new Vec3(0.3, -0.2, 0.7);
        assertEquals(v, transform.direction(v), "not a bit is turned");
    }

    /** Lengths and handedness are preserved and the partner's map inverts it, at the origin and at 10 km. */
    @Test
    void isRigidAndLeadsBack() {
        var random = new SplittableRandom(1);
        for (int i = 0; i < 2000; i++) {
            double away = i % 2 == 0 ? 1 : 10_000;
            Portal a = portal(any(random, away), any(random, 1), any(random, 1));
            Portal b = portal(any(random, away), any(random, 1), any(random, 1));
            PortalTransform there = PortalTransform.between(a, b);
            PortalTransform back = PortalTransform.between(b, a);
            Vec3 p = a.world(random.nextDouble(-2, 2), random.nextDouble(-2, 2), random.nextDouble(-2, 2));
            Vec3 q = there.point(p);
            assertNear(p, back.point(q), 1e-15 * away + 1e-14);
            double inFront = a.inFront(p.x(), p.y(), p.z());
            assertEquals(-inFront, b.inFront(q.x(), q.y(), q.z()), 1e-14 * away + 1e-14, "behind becomes before");
            assertEquals(-a.across(p.x(), p.y(), p.z()), b.across(q.x(), q.y(), q.z()), 1e-14 * away + 1e-14);
            assertEquals(1, there.rotation().determinant(), 1e-12);
            Vec3 v = any(random, 5);
            assertEquals(v.toVector().length(), there.direction(v).toVector().length(), 1e-12);
            Quaterniond turn = there.orientation(new Quaterniond());
            Vector3d turned = turn.transform(v.toVector());
            assertNear(there.direction(v), new Vec3(turned.x, turned.y, turned.z), 1e-12);
        }
    }

    /** A portal with a partner has a map to it; one without is closed and has none. */
    @Test
    void portalsKnowTheirPartners() {
        Portal a = portal(Vec3.ZERO, new Vec3(0, 0, 1), UP);
        Portal b = portal(new Vec3(5, 0, 0), new Vec3(1, 0, 0), UP);
        Portals portals = new Portals(List.of(a, b, a), List.of(1, 0, Portals.CLOSED));
        assertTrue(portals.isOpen(0) && portals.isOpen(1));
        assertFalse(portals.isOpen(2));
        assertNull(portals.transform(2));
        assertEquals(0, portals.partner(portals.partner(0)));
        assertNear(b.centre(), portals.transform(0).point(a.centre()), 1e-15);
        assertEquals(0, Portals.NONE.size());
    }
}
