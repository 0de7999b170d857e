package nephele.engine.sim.reach;

import static org.junit.jupiter.api.Assertions.assertAll;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import nephele.engine.level.json.LevelJson;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.sim.Simulation;
import org.junit.jupiter.api.Test;

class EyeReachTest {
    private static final String GROUND = box("ground", "0, -0.5, 0", "20, 1, 20");
    private static final String ROOM = GROUND
            + box("north", "0, 5, -10", "21, 12, 0.2")
            + box("south", "0, 5, 10", "21, 12, 0.2")
            + box("west", "-10, 5, 0", "0.2, 12, 21")
            + box("east", "10, 5, 0", "0.2, 12, 21");
    private static final double STANDING = 1.65;
    private static final double JUMP = 1;

    private static String box(String id, String centre, String size) {
        return box(id, centre, size, "");
    }

    private static String box(String id, String centre, String size, String more) {
        return "{'id': '" + id + "', 'kind': 'box', 'centre': [" + centre + "], 'size': [" + size + "]" + more + "},";
    }

    private static EyeReach reach(String solids, String more) {
        String json = "{'format': 'nephele-level', 'version': 1, 'player': {'feet': [0, 0, 0]}, 'solids': ["
                + solids.substring(0, solids.length() - 1) + "]" + more + "}";
        var level = LevelJson.read("reach", json.replace('\'', '"').getBytes(StandardCharsets.UTF_8));
        return EyeReach.of(level, StaticShapes.of(level));
    }

    private static boolean contains(EyeReach reach, double x, double y, double z) {
        return reach.parts().stream().anyMatch(part -> part.box().contains(x, y, z));
    }

    @Test
    void wallsKeepTheEyeInsideAndGravityKeepsItLow() {
        EyeReach reach = reach(ROOM, "");
        Aabb bounds = reach.bounds();
        double cell = 1.1;
        assertAll(
                () -> assertTrue(contains(reach, 9, 1.65, 9)),
                () -> assertTrue(bounds.maxX() <= 10 + cell && bounds.minX() >= -10 - cell, bounds.toString()),
                () -> assertTrue(bounds.maxZ() <= 10 + cell && bounds.minZ() >= -10 - cell, bounds.toString()),
                () -> assertTrue(bounds.maxY() >= STANDING + JUMP - cell, bounds.toString()),
                () -> assertTrue(bounds.maxY() <= STANDING + JUMP + cell, bounds.toString()));
    }

    @Test
    void ajumpReachesALowStepButNotAHighOne() {
        EyeReach low = reach(ROOM + box("step", "5, 0.45, 5", "6, 0.9, 6"), "");
        EyeReach high = reach(ROOM + box("step", "5, 1.5, 5", "6, 3, 6"), "");
        double above = 3 + STANDING;
        assertTrue(contains(low, 5, 0.9 + STANDING + JUMP - 0.1, 5));
        assertFalse(contains(high, 5, above, 5));
        EyeReach stairs = reach(
                ROOM
                        + box("one", "-5, 0.45, 5", "4, 0.9, 6")
                        + box("two", "-1, 0.9, 5", "4, 1.8, 6")
                        + box("step", "5, 1.35, 5", "8, 2.7, 6"),
                "");
        assertTrue(contains(stairs, 5, 2.7 + STANDING, 5));
    }

    @Test
    void offAnEdgeTheEyeFallsAsFarAsThePlayerDoes() {
        Aabb bounds = reach(GROUND, "").bounds();
        assertEquals(-1 - Simulation.FALL_METRES, bounds.minY(), 2);
        assertTrue(bounds.maxX() > 20 && bounds.maxX() < 60, bounds.toString());
        assertTrue(bounds.maxY() < STANDING + JUMP + 1, bounds.toString());
    }

    @Test
    void aPortalLeadsElsewhereAndKeepsTheEnergyOfAFall() {
        String far = box("far", "0, 99.5, -60", "8, 1, 8");
        String portals = ", 'portals': [{'id': 'a', 'linkedTo': 'b', 'centre': [0, 1.05, -9.9], 'normal': [0, 0, 1]},"
                + "{'id': 'b', 'linkedTo': 'a', 'centre': [0, 101.1, -60], 'normal': [0, 0, -1]}]";
        EyeReach closed = reach(ROOM + far, "");
        EyeReach open = reach(ROOM + far, portals);
        var there = new Aabb(-1, 101, -62, 1, 102, -61);
        assertAll(
                () -> assertTrue(EyeReach.metresBetween(closed.nearest(there).box(), there) > 40),
                () -> assertEquals(0, EyeReach.metresBetween(open.nearest(there).box(), there)),
                () -> assertEquals(EyeReach.Means.PORTALS, open.nearest(there).means()),
                () -> assertEquals(
                        EyeReach.Means.WALKING,
                        open.nearest(new Aabb(0, 1, 0, 0, 1, 0)).means()));
    }

    @Test
    void aGunReachesEveryPortalableFace() {
        String far = box("far", "0, 39.5, -60", "8, 1, 8", ", 'faces': {'+y': {'portalable': true}}");
        EyeReach without = reach(ROOM + far, "");
        EyeReach with = reach(ROOM + far, ", 'portalGun': {}");
        assertFalse(contains(without, 0, 41, -60));
        assertTrue(contains(with, 0, 41, -60));
    }

    @Test
    void withoutAPlayerTheEyeCanBeAnywhereAndCamerasCount() {
        assertTrue(EyeReach.ANYWHERE.isAnywhere());
        EyeReach reach = reach(ROOM, ", 'cameras': [{'id': 'high', 'position': [0, 500, 0], 'target': [0, 0, 0]}]");
        var high = new Aabb(0, 500, 0, 0, 500, 0);
        assertEquals(EyeReach.Means.CAMERAS, reach.nearest(high).means());
        assertEquals(500, reach.farthestMetres(Vec3.ZERO), 1);
    }
}
