package nephele.engine.collision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.level.PortalShape;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.ItemList;
import nephele.engine.portal.Obstacles;
import nephele.engine.portal.PathTrace;
import nephele.engine.portal.Portal;
import nephele.engine.portal.Portals;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The static world opened at the portals is solid exactly where paths through the apertures end in solids. */
@Execution(ExecutionMode.CONCURRENT)
final class PortalWorldTest {
    private static final Vec3 FAR = new Vec3(10_000, 300, -10_000);
    private static final RoundedHull PLAYER = RoundedHull.uprightCapsule(0.3, 1.8);

    private static boolean isSolid(CollisionWorld world, Vector3d p) {
        ItemList near = new ItemList();
        world.overlapping(new Aabb(p.x, p.y, p.z, p.x, p.y, p.z), near);
        for (int i = 0; i < near.size(); i++) {
            if (world.collider(near.get(i)).containsStrictly(p.x, p.y, p.z)) {
                return true;
            }
        }
        return false;
    }

    /** Returns true if no plane of a solid is so near that rounding decides. */
    private static boolean isClear(CollisionWorld world, Vector3d p) {
        for (int i = 0; i < world.size(); i++) {
            Collider solid = world.collider(i);
            for (int face = 0; face < solid.faces(); face++) {
                double d = solid.inFrontOf(
                        face,
                        p.x - solid.centre().x(),
                        p.y - solid.centre().y(),
                        p.z - solid.centre().z());
                if (Math.abs(d) < 1e-5) {
                    return false;
                }
            }
        }
        return true;
    }

    /** A point reached by a straight path through apertures is solid exactly if that path ends in a solid. */
    @ParameterizedTest
    @ValueSource(
            strings = {"walls", "floor and wall", "floor and ceiling", "corner", "side by side", "facing", "slanted"})
    void agreesWithStraightPaths(String kind) {
        for (Vec3 origin : new Vec3[] {Vec3.ZERO, FAR}) {
            PortalPairs place = PortalPairs.of(kind, origin);
            PortalWorld portalWorld = PortalWorld.of(place.statics(), place.portals());
            assertSame(place.portals(), portalWorld.portals(), "both exits are free");
            PathTrace trace = new PathTrace(place.portals(), Obstacles.NONE);
            SplittableRandom random = new SplittableRandom(kind.hashCode());
            int through = 0;
            int solid = 0;
            int both = 0;
            for (int i = 0; i < 4000; i++) {
                int entry = random.nextInt(2);
                Portal portal = place.portals().portal(entry);
                Vec3 eye =
                        portal.world(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(0.01, 0.8));
                Vec3 on = portal.world(random.nextDouble(-0.6, 0.6), random.nextDouble(-1, 1), 0);
                double beyond = random.nextDouble(1.05, 3);
                var from = eye.toVector();
                var way = on.toVector().sub(from).mul(beyond);
                if (way.length() > 2) {
                    way.normalize(2);
                }
                trace.trace(from, way);
                if (trace.crossings() == 0 || trace.entered(0) != entry || trace.crossings() > 3) {
                    continue;
                }
                Vector3d here = from.add(way);
                Vector3d there = new Vector3d(trace.place());
                if (!isClear(place.statics(), there) || isBehindAny(place.portals(), there)) {
                    continue;
                }
                through++;
                boolean expected = isSolid(place.statics(), there);
                solid += expected ? 1 : 0;
                assertEquals(
                        expected,
                        isSolid(portalWorld.openedFor(1L << entry), here),
                        kind + " " + i + " at " + origin + ": " + here + " is " + there + " by " + trace);
                if (isItsOwn(kind, place.portals(), entry, here)) {
                    both++;
                    assertEquals(expected, isSolid(portalWorld.openedFor(3), here), kind + " " + i + " active on both");
                }
            }
            assertTrue(through > 400, kind + ": paths " + through);
            assertTrue(solid > 0, kind + ": solid ends " + solid);
            assertTrue(both > 200 || !kind.equals("corner") && !kind.equals("side by side"), kind + ": both " + both);
        }
    }

    /** Returns true if a point behind an entry belongs to that entry, for a body active on both portals. */
    private static boolean isItsOwn(String kind, Portals portals, int entry, Vector3d p) {
        Portal mine = portals.portal(entry);
        Portal other = portals.portal(1 - entry);
        return switch (kind) {
            case "corner" -> mine.inFront(p.x, p.y, p.z) < other.inFront(p.x, p.y, p.z) - 1e-3;
            case "side by side" -> Math.abs(mine.across(p.x, p.y, p.z)) < 0.59;
            default -> false;
        };
    }

    private static boolean isBehindAny(Portals portals, Vector3d p) {
        for (int i = 0; i < portals.size(); i++) {
            if (portals.portal(i).inFront(p.x, p.y, p.z) < 0.02) {
                return true;
            }
        }
        return false;
    }

    /**
     * A portal without a partner is closed, and so is a pair with an exit inside a solid; an obstructed exit stays
     * open.
     */
    @Test
    void invalidExitsAreClosed() {
        Portal a =
                PortalPairs.portal("a", new Vec3(0, 1.05, 0), new Vec3(0, 0, 1), new Vec3(0, 1, 0), PortalShape.ARCH);
        Portal b =
                PortalPairs.portal("b", new Vec3(9, 1.05, 0), new Vec3(0, 0, 1), new Vec3(0, 1, 0), PortalShape.ARCH);
        double[] wall = {-20, 0, -1, 20, 5, 0};
        Portals pair = new Portals(List.of(a, b), List.of(1, 0));
        CollisionWorld free = PortalPairs.boxes(Vec3.ZERO, wall);
        assertTrue(PortalWorld.of(free, pair).portals().isOpen(0));
        CollisionWorld narrow = PortalPairs.boxes(Vec3.ZERO, wall, new double[] {9.1, 0, 0, 10, 3, 1});
        assertTrue(PortalWorld.of(narrow, pair).portals().isOpen(0));
        CollisionWorld blocked = PortalPairs.boxes(Vec3.ZERO, wall, new double[] {8, 0, -0.5, 10, 3, 1});
        PortalWorld closed = PortalWorld.of(blocked, pair);
        assertFalse(closed.portals().isOpen(0) || closed.portals().isOpen(1));
        Vector3d before = new Vector3d(0, 1, 0.4);
        assertEquals(0, closed.active(PLAYER, before, new Vector3d(0, 0, -1)));
        assertSame(blocked, closed.openedFor(3), "a stale mask opens nothing");
        PortalWorld single = PortalWorld.of(free, new Portals(List.of(a), List.of(Portals.CLOSED)));
        assertEquals(0, single.active(PLAYER, before, new Vector3d(0, 0, -1)));
    }

    /** A body is active in front of a portal, near it or on the path to it, but not around the wall's edge. */
    @Test
    void activeFromFirstTouchToLastLeave() {
        Portal a =
                PortalPairs.portal("a", new Vec3(0, 1.05, 0), new Vec3(0, 0, 1), new Vec3(0, 1, 0), PortalShape.ARCH);
        Portal b =
                PortalPairs.portal("b", new Vec3(9, 1.05, 0), new Vec3(0, 0, 1), new Vec3(0, 1, 0), PortalShape.ARCH);
        CollisionWorld pillar = PortalPairs.boxes(
                Vec3.ZERO, new double[] {-0.65, 0, -1, 0.65, 5, 0}, new double[] {8, 0, -1, 10, 5, 0});
        PortalWorld portalWorld = PortalWorld.of(pillar, new Portals(List.of(a, b), List.of(1, 0)));
        Vector3d still = new Vector3d();
        assertEquals(1, portalWorld.active(PLAYER, new Vector3d(0, 1, 0.31), still));
        assertEquals(1, portalWorld.active(PLAYER, new Vector3d(0, 1, 0), still), "half-way");
        assertEquals(1, portalWorld.active(PLAYER, new Vector3d(0, 1, 30), new Vector3d(0, 0, -40)), "in a tick");
        assertEquals(0, portalWorld.active(PLAYER, new Vector3d(0, 1, 0.4), still), "not yet");
        assertEquals(0, portalWorld.active(PLAYER, new Vector3d(0, 1, -0.01), still), "behind");
        assertEquals(0, portalWorld.active(PLAYER, new Vector3d(2, 1, 0.1), still), "beside");
        assertEquals(0, portalWorld.active(PLAYER, new Vector3d(0.93, 1, 0.1), still), "round the edge");
        RoundedHull box = RoundedHull.box(new Vec3(0.6, 0, 0), new Vec3(0, 0.2, 0), new Vec3(0, 0, 0.2));
        assertEquals(0, portalWorld.active(box, new Vector3d(1.26, 1, 0.1), still), "a box round the edge");
        assertEquals(
                1, portalWorld.active(box, new Vector3d(1.1, 1, 0.21), new Vector3d(0, 0, 0.01)), "before the wall");
        assertEquals(
                0, portalWorld.active(box, new Vector3d(1.1, 1, 0.21), new Vector3d(0.16, 0, -0.1)), "going round");
        assertEquals(1, portalWorld.active(PLAYER, new Vector3d(0.2, 1, 0.4), new Vector3d(2, 0, -2)), "far beyond");
        assertEquals(1, portalWorld.active(box, new Vector3d(0, 1, 0.1), still), "a box in it");
        RoundedHull rod = RoundedHull.box(new Vec3(-0.7, 0, 0.7), new Vec3(0, 0.01, 0), new Vec3(0.01, 0, 0.01));
        Vector3d leans = new Vector3d(0.25, 1, 0.3);
        assertEquals(1, portalWorld.active(rod, leans, still), "a rod through it");
        assertEquals(1, portalWorld.active(rod, leans, new Vector3d(0.1, 0, 0)), "a rod that the rim is about to stop");
    }

    /** Solids outside every aperture volume are shared, and the world of a mask is built once. */
    @Test
    void sharesWhatIsFar() {
        PortalPairs place = PortalPairs.of("walls", Vec3.ZERO);
        PortalWorld portalWorld = PortalWorld.of(place.statics(), place.portals());
        assertSame(place.statics(), portalWorld.openedFor(0));
        CollisionWorld around = portalWorld.openedFor(1);
        assertSame(around, portalWorld.openedFor(1));
        ItemList all = new ItemList();
        around.overlapping(place.statics().extent().grown(9), all);
        int shared = 0;
        for (int i = 0; i < all.size() && all.get(i) < place.statics().size(); i++) {
            assertSame(place.statics().collider(all.get(i)), around.collider(all.get(i)));
            shared++;
        }
        assertTrue(shared >= 3 && shared < place.statics().size(), "shared " + shared);
    }
}
