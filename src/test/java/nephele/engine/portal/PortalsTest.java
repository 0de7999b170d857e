package nephele.engine.portal;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import nephele.engine.level.PortalShape;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/** A point is on the other side if the segment to it from its shape's centre crosses the aperture. */
class PortalsTest {
    private static final Vec3 UP = new Vec3(0, 1, 0);
    private static final Aperture APERTURE = Aperture.of(PortalShape.RECTANGLE, 1.2, 2.1);

    private static long through(Vector3d centre, Vector3d point) {
        Portal a = new Portal("a", Vec3.ZERO, Portal.facing(new Vec3(0, 0, 1), UP), APERTURE);
        Portal b = new Portal("b", new Vec3(40, 0, 0), Portal.facing(new Vec3(0, 0, 1), UP), APERTURE);
        return new Portals(List.of(a, b), List.of(1, 0)).behind(3, centre, point);
    }

    @Test
    void theLineFromTheCentreDecides() {
        // A quarter of the segment is in front of the plane.
        Vector3d centre = new Vector3d(0, 0, 0.2);
        assertEquals(1, through(centre, new Vector3d(2.2, 0, -0.6)), "meets the plane 0.55 m off the middle");
        assertEquals(0, through(centre, new Vector3d(2.6, 0, -0.6)), "0.65 m");
        assertEquals(1, through(centre, new Vector3d(0, -4, -0.6)), "1 m below");
        assertEquals(0, through(centre, new Vector3d(0, -4.4, -0.6)), "1.1 m below");
        assertEquals(0, through(centre, new Vector3d(0, 0, 0)), "on the plane");
        assertEquals(2, through(new Vector3d(40.3, 0, 0), new Vector3d(45, 0, -1)), "the centre lies in the aperture");
        assertEquals(0, through(new Vector3d(40.7, 0, 0), new Vector3d(40, 0, -1)), "the centre lies beside it");
    }
}
