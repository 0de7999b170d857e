package nephele.engine.portal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.level.PortalShape;
import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;
import nephele.engine.portal.PathTrace.End;
import org.joml.Quaterniond;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;

final class PathTraceTest {
    private final SplittableRandom random = new SplittableRandom(3);

    private static Portal portal(String id, Vec3 centre, Vec3 normal) {
        Vec3 up = Math.abs(normal.y()) > 0.9 ? new Vec3(0, 0, -1) : new Vec3(0, 1, 0);
        return new Portal(id, centre, Portal.facing(normal, up), Aperture.of(PortalShape.ARCH, 1.2, 2.1));
    }

    /** Returns the portals in the pairs 0–1, 2–3, and so on. */
    private static Portals pairs(List<Portal> portals) {
        List<Integer> partners = new ArrayList<>();
        for (int i = 0; i < portals.size(); i++) {
            partners.add(i ^ 1);
        }
        return new Portals(portals, partners);
    }

    private Vector3d direction() {
        Vector3d v = new Vector3d();
        do {
            v.set(2 * random.nextDouble() - 1, 2 * random.nextDouble() - 1, 2 * random.nextDouble() - 1);
        } while (v.lengthSquared() > 1 || v.lengthSquared() < 0.01);
        return v.normalize();
    }

    private Vector3d place(double reach) {
        return new Vector3d(2 * random.nextDouble() - 1, 2 * random.nextDouble() - 1, 2 * random.nextDouble() - 1)
                .mul(reach);
    }

    /**
     * Returns the inside of a cube of 4 m with two portals in each face, linked at random: most paths cross several
     * times.
     */
    private Portals crowd() {
        var aperture = Aperture.of(random.nextBoolean() ? PortalShape.ARCH : PortalShape.ELLIPSE, 1.8, 3.6);
        List<Portal> portals = new ArrayList<>();
        for (int i = 0; i < 12; i++) {
            int axis = i / 4;
            double side = (i & 1) == 0 ? 1 : -1;
            double off = (i & 2) == 0 ? 0.95 : -0.95;
            double[] centre = new double[3];
            double[] normal = new double[3];
            centre[axis] = 2 * side;
            centre[axis == 0 ? 2 : 0] = off;
            normal[axis] = -side;
            Vec3 up = axis == 1 ? new Vec3(0, 0, -1) : new Vec3(0, 1, 0);
            Basis frame = Portal.facing(new Vec3(normal[0], normal[1], normal[2]), up);
            portals.add(new Portal("p" + i, new Vec3(centre[0], centre[1], centre[2]), frame, aperture));
        }
        return new Portals(portals, linkedAtRandom(portals.size()));
    }

    private List<Integer> linkedAtRandom(int count) {
        List<Integer> order = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            order.add(random.nextInt(order.size() + 1), i);
        }
        Integer[] partners = new Integer[count];
        for (int i = 0; i < count; i += 2) {
            partners[order.get(i)] = order.get(i + 1);
            partners[order.get(i + 1)] = order.get(i);
        }
        return List.of(partners);
    }

    /** Returns the free share of a displacement within the cube's walls. */
    private static double toCube(Vector3dc from, Vector3dc way) {
        double free = 1;
        for (int axis = 0; axis < 3; axis++) {
            double wall = way.get(axis) > 0 ? 2 : -2;
            if (way.get(axis) != 0) {
                free = Math.min(free, Math.max(0, (wall - from.get(axis)) / way.get(axis)));
            }
        }
        return free;
    }

    /** Returns pairs 2 i and 2 i + 1: a straight ray along −z enters them one after another, 2 m apart. */
    private static Portals chain(int pairs) {
        List<Portal> portals = new ArrayList<>();
        for (int i = 0; i < pairs; i++) {
            double x = 10 * i;
            portals.add(portal("in" + i, new Vec3(x, 1, -1), new Vec3(0, 0, 1)));
            portals.add(portal("out" + i, new Vec3(x + 10, 1, 1), new Vec3(0, 0, -1)));
        }
        return pairs(portals);
    }

    /** Returns an infinite wall at this z, for displacements along −z. */
    private static Obstacles wallAtZ(double z) {
        return (from, way) -> way.z() < 0 ? Math.max(0, Math.min(1, (z - from.z()) / way.z())) : 1;
    }

    @Test
    void withoutPortalsItIsTheSegment() {
        var trace = new PathTrace(Portals.NONE, Obstacles.NONE);
        assertEquals(End.ARRIVED, trace.trace(new Vector3d(1, 2, 3), new Vector3d(4, 5, 6)));
        assertEquals(new Vector3d(5, 7, 9), trace.place());
        assertEquals(1, trace.freeFraction());
        assertEquals(CrossingWord.EMPTY, trace.word());
        assertEquals(End.ARRIVED, trace.trace(new Vector3d(1, 2, 3), new Vector3d()));
    }

    /** A segment cut into 1 to 64 pieces has the same end and the same word as the whole. */
    @Test
    void piecesGoWhereTheWholeGoes() {
        int crossings = 0;
        for (int i = 0; i < 200; i++) {
            Portals portals = crowd();
            var whole = new PathTrace(portals, PathTraceTest::toCube);
            Vector3d from = place(1.9);
            Vector3d way = direction().mul(1 + 20 * random.nextDouble());
            End end = whole.trace(from, way);
            crossings += whole.crossings();
            for (int pieces = 1; pieces <= 64; pieces += 1 + random.nextInt(8)) {
                var walked = new Walked(portals, from);
                assertEquals(end, walked.go(way, pieces));
                assertEquals(whole.word(), walked.word, "pieces: " + pieces);
                assertEquals(0, whole.place().distance(walked.place), 1e-9);
            }
        }
        assertTrue(crossings > 300, "crossings: " + crossings);
    }

    /** A path in pieces: each begins at the end of the last one. */
    private static final class Walked {
        private final Portals portals;
        private final PathTrace trace;
        private final Vector3d place;
        private CrossingWord word = CrossingWord.EMPTY;

        Walked(Portals portals, Vector3dc from) {
            this.portals = portals;
            trace = new PathTrace(portals, PathTraceTest::toCube);
            place = new Vector3d(from);
        }

        End go(Vector3dc way, int pieces) {
            Vector3d piece = new Vector3d(way).div(pieces);
            End end = End.ARRIVED;
            for (int i = 0; i < pieces && end == End.ARRIVED; i++) {
                end = trace.trace(place, piece);
                place.set(trace.place());
                trace.carryDirection(piece);
                for (int j = 0; j < trace.crossings(); j++) {
                    word = word.then(trace.entered(j), portals);
                }
            }
            return end;
        }
    }

    /** A path followed by the same path backwards has the empty word and ends at the start; its map is rigid. */
    @Test
    void theWayBackLeadsBack() {
        for (int i = 0; i < 500; i++) {
            Portals portals = crowd();
            var trace = new PathTrace(portals, PathTraceTest::toCube);
            Vector3d from = place(1.9);
            Vector3d way = direction().mul(8);
            trace.trace(from, way);
            way.mul(trace.freeFraction());
            Vector3d end = new Vector3d(trace.place());
            CrossingWord there = trace.word();
            assertEquals(0, trace.carryPoint(new Vector3d(from).add(way)).distance(end), 1e-9);
            Vector3d turned = trace.carryDirection(new Vector3d(way));
            Quaterniond orientation = new Quaterniond();
            for (int j = 0; j < trace.crossings(); j++) {
                portals.transform(trace.entered(j)).orientation(orientation);
            }
            Vector3d byOrientation = orientation.transform(new Vector3d(way));
            assertEquals(0, turned.distance(byOrientation), 1e-9);
            trace.trace(end, turned.negate());
            CrossingWord thereAndBack = there;
            for (int j = 0; j < trace.crossings(); j++) {
                thereAndBack = thereAndBack.then(trace.entered(j), portals);
            }
            assertEquals(CrossingWord.EMPTY, thereAndBack);
            assertEquals(0, from.distance(trace.place()), 1e-9);
        }
    }

    /** A ray through 0 to 16 portals ends at its target, and its length is that of the whole path. */
    @Test
    void aShaftThroughManyPortalsMeasuresItsWholePath() {
        for (int pairs = 0; pairs <= 16; pairs++) {
            // 2 m in front of the first wall, 2 m between an exit and the next entry, a wall 0.75 m beyond the last
            // exit.
            double whole = pairs == 0 ? 1.75 : 2 + 2 * (pairs - 1) + 0.75;
            double target = pairs == 0 ? -0.75 : 0.25;
            double lastX = 10 * pairs;
            Obstacles wall = (from, way) ->
                    Math.abs(from.x() - lastX) < 1 ? wallAtZ(target).free(from, way) : 1;
            var trace = new PathTrace(chain(pairs), wall);
            assertEquals(End.BLOCKED, trace.trace(new Vector3d(0, 1, 1), new Vector3d(0, 0, -100)));
            assertEquals(pairs, trace.crossings());
            assertEquals(pairs, trace.word().length());
            assertEquals(whole, 100 * trace.freeFraction(), 1e-9);
            assertEquals(0, trace.place().distance(new Vector3d(lastX, 1, target)), 1e-9);
            // A path slightly shorter than this is not blocked, whatever portals it crosses.
            assertEquals(End.ARRIVED, trace.trace(new Vector3d(0, 1, 1), new Vector3d(0, 0, -whole + 1e-6)));
        }
    }

    /** Between facing portals a ray ends at the limit of crossings, however long it is. */
    @Test
    void aClosedLoopEndsAtTheCap() {
        Portal near = portal("near", new Vec3(0, 1, 0), new Vec3(0, 0, -1));
        Portal far = portal("far", new Vec3(0, 1, -2), new Vec3(0, 0, 1));
        var trace = new PathTrace(pairs(List.of(near, far)), Obstacles.NONE);
        assertEquals(End.TOO_MANY_CROSSINGS, trace.trace(new Vector3d(0, 1, -1), new Vector3d(0, 0, -1e9)));
        assertEquals(PathTrace.MOST_CROSSINGS, trace.crossings());
        double metres = 1 + 2.0 * PathTrace.MOST_CROSSINGS;
        assertEquals(metres, 1e9 * trace.freeFraction(), 1e-5);
        assertEquals(PathTrace.MOST_CROSSINGS, trace.word().length());
        assertEquals(End.ARRIVED, trace.trace(new Vector3d(0, 1, -1), new Vector3d(0, 0, -100)));
        assertEquals(50, trace.crossings());
    }

    /**
     * Three pairs lead a ray back to its own start, 2 m a leg: it ends at the limit of crossings, and any shorter path
     * ends after exactly its length.
     */
    @Test
    void aShaftThatRunsIntoItsOwnStartEndsAtTheCap() {
        Portals ring = pairs(List.of(
                portal("in 0", new Vec3(0, 1, -1), new Vec3(0, 0, 1)),
                portal("out 0", new Vec3(5, 1, 0), new Vec3(1, 0, 0)),
                portal("in 1", new Vec3(7, 1, 0), new Vec3(-1, 0, 0)),
                portal("out 1", new Vec3(5, 1, 5), new Vec3(0, 0, 1)),
                portal("in 2", new Vec3(5, 1, 7), new Vec3(0, 0, -1)),
                portal("out 2", new Vec3(0, 1, 1), new Vec3(0, 0, -1))));
        var trace = new PathTrace(ring, Obstacles.NONE);
        Vector3d start = new Vector3d(0, 1.2, 1);
        assertEquals(End.TOO_MANY_CROSSINGS, trace.trace(start, new Vector3d(0, 0, -1e6)));
        assertEquals(PathTrace.MOST_CROSSINGS, trace.crossings());
        assertEquals(2.0 * (PathTrace.MOST_CROSSINGS + 1), 1e6 * trace.freeFraction(), 1e-7);
        assertEquals(0, trace.place().distance(new Vector3d(7, 1.2, 0)), 1e-9);
        for (int legs = 1; legs <= PathTrace.MOST_CROSSINGS; legs++) {
            assertEquals(End.ARRIVED, trace.trace(start, new Vector3d(0, 0, 1e-6 - 2 * legs)), legs + " legs");
            assertEquals(legs - 1, trace.crossings());
            assertEquals(1, trace.freeFraction());
            Vector3d arrives =
                    switch (legs % 3) {
                        case 1 -> new Vector3d(0, 1.2, -1);
                        case 2 -> new Vector3d(7, 1.2, 0);
                        default -> new Vector3d(5, 1.2, 7);
                    };
            assertEquals(0, trace.place().distance(arrives), 2e-6, legs + " legs");
        }
    }

    /** A path through a portal is not blocked by the wall around it, but by obstacles in front of it. */
    @Test
    void theHostWallIsOpenAndNothingElse() {
        Portals portals = chain(1);
        // The entry's wall is flush with its plane, or 1e-9 m in front of or behind it.
        for (double z : new double[] {-1, -1 + 1e-9, -1 - 1e-9}) {
            var trace = new PathTrace(
                    portals, (from, way) -> from.x() < 5 ? wallAtZ(z).free(from, way) : 1);
            assertEquals(End.ARRIVED, trace.trace(new Vector3d(0, 1, 0), new Vector3d(0, 0, -3)));
            assertEquals(End.BLOCKED, trace.trace(new Vector3d(0.7, 1, 0), new Vector3d(0, 0, -3)));
            assertEquals(1.0 / 3, trace.freeFraction(), 1e-8);
        }
        var grating = new PathTrace(
                portals, (from, way) -> from.x() < 5 ? wallAtZ(-0.95).free(from, way) : 1);
        assertEquals(End.BLOCKED, grating.trace(new Vector3d(0, 1, 0), new Vector3d(0, 0, -3)));
        assertEquals(CrossingWord.EMPTY, grating.word());
    }

    /** A path that is not finite terminates. */
    @Test
    void whatIsNotANumberEnds() {
        var trace = new PathTrace(crowd(), Obstacles.NONE);
        for (double bad : new double[] {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY}) {
            trace.trace(new Vector3d(), new Vector3d(0, bad, 1));
            assertTrue(trace.crossings() <= PathTrace.MOST_CROSSINGS);
            trace.trace(new Vector3d(bad, 0, 0), new Vector3d(0, 0, 1));
            assertEquals(0, trace.crossings());
        }
    }
}
