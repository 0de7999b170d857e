package nephele.engine.collision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.level.PortalShape;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portal;
import org.junit.jupiter.api.Test;

/** A plane divides the space behind two portals between their aperture volumes. */
class ApertureVolumeTest {
    private static final Vec3 UP = new Vec3(0, 1, 0);
    private static final Vec3 SOUTH = new Vec3(0, 0, 1);

    private static Portal portal(double x, double y, double z, Vec3 normal) {
        return PortalPairs.portal("p", new Vec3(x, y, z), normal, UP, PortalShape.RECTANGLE);
    }

    @Test
    void behindPortalsSideBySideTheMiddleBetweenThemDivides() {
        Plane plane = ApertureVolume.dividing(portal(0, 1, 0, SOUTH), portal(1.6, 1, 0, SOUTH));
        assertEquals(-0.2, plane.signedDistance(new Vec3(0.6, 1, 0)), 1e-12);
        assertEquals(0.2, plane.signedDistance(new Vec3(1, 1, -7)), 1e-12);
        Plane above = ApertureVolume.dividing(portal(0, 0, 0, SOUTH), portal(0.3, -3.1, 0, SOUTH));
        assertEquals(-0.5, above.signedDistance(new Vec3(0.9, -1.05, 0)), 1e-12);
        assertEquals(0.5, above.signedDistance(new Vec3(0.9, -2.05, 0)), 1e-12);
    }

    @Test
    void inACornerWhatIsAsDeepBehindBothDivides() {
        Portal a = portal(-4.4, 1, -5, SOUTH);
        Portal b = portal(-5, 1, -4.4, new Vec3(1, 0, 0));
        Plane plane = ApertureVolume.dividing(a, b);
        assertEquals(0, plane.signedDistance(new Vec3(-5.7, 3, -5.7)), 1e-12);
        assertTrue(plane.signedDistance(new Vec3(-4.4, 1, -6)) < -0.5, "deeper behind the first");
    }

    @Test
    void portalsThatCoverEachOtherShareNothing() {
        assertNull(ApertureVolume.dividing(portal(0, 1, 0, SOUTH), portal(0.5, 1, 0, SOUTH)));
    }
}
