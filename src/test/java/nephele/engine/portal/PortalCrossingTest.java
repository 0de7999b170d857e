package nephele.engine.portal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.level.PortalShape;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A point enters the right portal at the right time. */
final class PortalCrossingTest {
    private static final Vector3d NONE = new Vector3d();
    private static final Vec3 UP = new Vec3(0, 1, 0);
    private static final Vec3 SOUTH = new Vec3(0, 0, 1);

    private static Portal portal(double x, double y, double z, Vec3 normal, Vec3 up) {
        Aperture aperture = Aperture.of(PortalShape.RECTANGLE, 1.2, 2.1);
        return new Portal("p", new Vec3(x, y, z), Portal.facing(normal, up), aperture);
    }

    private static Portals pair(Portal a, Portal b) {
        return new Portals(List.of(a, b), List.of(1, 0));
    }

    private static Portals wall(double away) {
        return pair(portal(away, away, away, SOUTH, UP), portal(away + 40, away, away, new Vec3(1, 0, 0), UP));
    }

    @Test
    void entersFromTheFrontWithinTheAperture() {
        Portals portals = wall(0);
        PortalCrossing crossing = new PortalCrossing();
        assertTrue(crossing.find(portals, new Vector3d(0, 0, 1), new Vector3d(0, 0, -4), NONE, 1));
        assertEquals(0, crossing.portal());
        assertEquals(0.25, crossing.seconds(), 1e-15);
        assertFalse(crossing.find(portals, new Vector3d(0, 0, -1), new Vector3d(0, 0, 4), NONE, 1), "from behind");
        assertFalse(crossing.find(portals, new Vector3d(0.61, 0, 1), new Vector3d(0, 0, -4), NONE, 1), "beside");
        assertFalse(crossing.find(portals, new Vector3d(0, 0, 1), new Vector3d(4, 0, 0), NONE, 1), "along");
        assertFalse(crossing.find(portals, new Vector3d(0, 0, 0), new Vector3d(0, 0, 1), NONE, 1), "out of it");
        assertFalse(crossing.find(portals, new Vector3d(0, 0, 0), new Vector3d(0, 0, 0), NONE, 1), "at rest in it");
        Portals closed = new Portals(List.of(portals.portal(0)), List.of(Portals.CLOSED));
        assertFalse(crossing.find(closed, new Vector3d(0, 0, 1), new Vector3d(0, 0, -4), NONE, 1), "closed");
    }

    /**
     * The interval is half-open: a path that ends on the plane does not cross, and the next one crosses at its start.
     */
    @Test
    void aWayThatEndsOnThePlaneCrossesNext() {
        Portals portals = wall(0);
        PortalCrossing crossing = new PortalCrossing();
        assertFalse(crossing.find(portals, new Vector3d(0, 0, 1), new Vector3d(0, 0, -1), NONE, 1));
        assertTrue(crossing.find(portals, new Vector3d(0, 0, 0), new Vector3d(0, 0, -1), NONE, 1));
        assertEquals(0, crossing.seconds());
        assertTrue(crossing.find(portals, new Vector3d(0, 0, -1e-13), new Vector3d(0, 0, -1), NONE, 1), "by rounding");
    }

    /** A path in 1 to 64 pieces crosses as often as the whole, from either side, at the origin and 10 km away. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 10_000})
    void piecesCrossAsOftenAsTheWhole(double away) {
        Portals portals = wall(away);
        PortalCrossing crossing = new PortalCrossing();
        var random = new SplittableRandom(3);
        int whole = 0;
        for (int i = 0; i < 2000; i++) {
            Vector3d from = new Vector3d(away + random.nextDouble(-1, 1), away + random.nextDouble(-1, 1), away);
            from.z += i % 5 == 0 ? 0 : random.nextDouble(-1, 1);
            Vector3d way = new Vector3d(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-2, 2));
            int expected = crossing.find(portals, from, way, NONE, 1) ? 1 : 0;
            whole += expected;
            for (int pieces = 1; pieces <= 64; pieces *= 2) {
                Vector3d place = new Vector3d(from);
                Vector3d part = new Vector3d(way).div(pieces);
                int crossed = 0;
                for (int k = 0; k < pieces && crossed == 0; k++) {
                    crossed += crossing.find(portals, place, part, NONE, 1) ? 1 : 0;
                    place.add(part);
                }
                assertEquals(expected, crossed, "way " + i + " in " + pieces + " pieces");
            }
        }
        assertTrue(whole > 250, "crossings " + whole);
    }

    /**
     * Times on a parabola are exact where the textbook formula cancels: slow and long, fast and near, up and down
     * again.
     */
    @Test
    void timesAreExactOnTheArc() {
        var random = new SplittableRandom(5);
        for (int i = 0; i < 10_000; i++) {
            double height = StrictMath.pow(10, random.nextDouble(-9, 3));
            double speed = (random.nextBoolean() ? 1 : -1) * StrictMath.pow(10, random.nextDouble(-6, 3));
            double t = PortalCrossing.descent(height, speed, -9.81);
            double scale = height + Math.abs(speed) * t + 4.9 * t * t;
            assertEquals(0, height + speed * t - 9.81 / 2 * t * t, 1e-14 * scale, "from " + height + " at " + speed);
            assertTrue(t > 0);
        }
        assertEquals(Double.NaN, PortalCrossing.descent(1, 1, 0), "away");
        assertEquals(Double.NaN, PortalCrossing.descent(1, 0, 0), "at rest");
        assertEquals(Double.NaN, PortalCrossing.descent(1, -1, 9.81), "turns before");
        assertEquals(1, PortalCrossing.descent(1, -1, 0), 1e-15);
        assertEquals(2, PortalCrossing.descent(0, 1, -1), 1e-15, "up from the plane and down again");
    }

    /** The earliest of several entries counts; of equally early ones the lowest index. */
    @Test
    void theEarliestCounts() {
        Portal near = portal(0, 0, -1, SOUTH, UP);
        Portal far = portal(0, 0, -2, SOUTH, UP);
        Portals portals = new Portals(List.of(far, near, near, far), List.of(1, 0, 3, 2));
        PortalCrossing crossing = new PortalCrossing();
        assertTrue(crossing.find(portals, new Vector3d(0, 0, 1), new Vector3d(0, 0, -10), NONE, 1));
        assertEquals(1, crossing.portal());
        assertEquals(0.2, crossing.seconds(), 1e-15);
    }
}
