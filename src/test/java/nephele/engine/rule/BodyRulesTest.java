package nephele.engine.rule;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.List;
import nephele.engine.level.Body;
import nephele.engine.level.Level;
import nephele.engine.level.Problem;
import nephele.engine.level.RoomLevel;
import nephele.engine.level.json.LevelJson;
import nephele.engine.level.placed.NoFiles;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;

/** Bodies that start in an overlap are reported, and those that only seem to are not. */
class BodyRulesTest {
    private static final Vec3 AHEAD = new Vec3(0, 0, 1);
    private static final Vec3 LEFT = new Vec3(1, 0, 0);

    private static List<Problem> errorsBeforeUse(Level level) {
        return LevelRules.errorsBeforeUse(level, NoFiles.AT_ALL, () -> StaticShapes.of(level, NoFiles.AT_ALL));
    }

    private static List<String> errors(RoomLevel room) {
        return errorsBeforeUse(room.level()).stream()
                .map(problem -> problem.path() + " " + problem.message())
                .toList();
    }

    private static void assertFree(RoomLevel room) {
        assertEquals(List.of(), errors(room));
    }

    private static void assertTold(RoomLevel room, String start) {
        List<String> errors = errors(room);
        assertEquals(1, errors.size(), errors.toString());
        assertTrue(errors.get(0).startsWith(start), errors.get(0));
    }

    /** A hall with a portal in the wall ahead that leads to the wall on the left. */
    private static RoomLevel portals() {
        return RoomLevel.hall().startAt(6, 0, 6, 0, 0).pair(new Vec3(0, 1.05, -8), AHEAD, new Vec3(-8, 1.05, 0), LEFT);
    }

    @Test
    void aMillimetreIsTouching() {
        assertFree(RoomLevel.hall().cube(new Vec3(3, 0.5 - 0.9e-3, 0), 1, 5));
        assertTold(
                RoomLevel.hall().cube(new Vec3(3, 0.5 - 1.2e-3, 0), 1, 5),
                "bodies[0].centre the body starts 1.2 mm deep in 'box0': move it out");
    }

    @Test
    void ballsAndCapsulesStartInWallsToo() {
        assertFree(RoomLevel.hall().body(new Body.Sphere("s", new Vec3(3, 0.25, 0), 0.25, 1, null, 0.5, 0)));
        assertTold(
                RoomLevel.hall().body(new Body.Sphere("s", new Vec3(7.9, 2, 0), 0.25, 1, null, 0.5, 0)),
                "bodies[0].centre the body starts 150 mm deep in 'box3'");
        assertTold(
                RoomLevel.hall().body(new Body.Capsule("c", new Vec3(3, 0.45, 0), 0.25, 1, 1, null, 0.5, 0)),
                "bodies[0].centre the body starts 50 mm deep in 'box0'");
    }

    @Test
    void whatReachesThroughAnOpenPortalIsInNothing() {
        assertFree(portals().cube(new Vec3(0, 1, -7.8), 0.8, 5));
        assertTold(
                RoomLevel.hall().startAt(6, 0, 6, 0, 0).cube(new Vec3(0, 1, -7.8), 0.8, 5),
                "bodies[0].centre the body starts 200 mm deep in 'box4'");
        assertTold(
                portals().cube(new Vec3(0.5, 1, -7.8), 0.8, 5), "bodies[0].centre the body starts 200 mm deep in 'box");
    }

    @Test
    void aSolidBeforeTheExitIsMetThroughThePortal() {
        RoomLevel room = portals().box(-7.9, 0.8, 0.2, -7.7, 1.2, 0.4);
        assertTold(room.cube(new Vec3(0, 1, -7.8), 0.8, 5), "bodies[0].centre the body starts ");
    }

    @Test
    void bodiesInEachOtherAreToldOnce() {
        RoomLevel room = RoomLevel.hall().cube(new Vec3(3, 0.5, 0), 1, 5);
        assertFree(room.cube(new Vec3(4, 0.5, 0), 1, 5));
        assertTold(
                room.cube(new Vec3(3.5, 1.498, 0), 1, 5),
                "bodies[2].centre the body starts 2 mm deep in bodies[0] ('cube0'): move one of them");
    }

    @Test
    void bodiesMeetThroughAPortal() {
        RoomLevel through = portals().cube(new Vec3(0, 1, -7.7), 0.8, 5);
        assertFree(through.cube(new Vec3(-7.5, 1, 0), 0.8, 5));
        assertTold(
                portals().cube(new Vec3(0, 1, -7.7), 0.8, 5).cube(new Vec3(-7.55, 1, 0), 0.8, 5),
                "bodies[0].centre the body starts 50 mm deep in bodies[1] ('cube1') through a portal");
        RoomLevel both = portals().cube(new Vec3(0, 1, -7.7), 0.8, 5).cube(new Vec3(-7.7, 1, 0), 0.8, 5);
        assertTold(both, "bodies[1].centre the body starts 200 mm deep in bodies[0] ('cube0') through a portal");
    }

    /** A body behind the exit's wall does not overlap one that reaches into the portal. */
    @Test
    void whatIsBehindTheExitsWallIsNotMet() {
        RoomLevel outside = portals().cube(new Vec3(0, 1, -7.7), 0.8, 5);
        assertFree(outside.cube(new Vec3(-9.5, 1, 0), 0.8, 5));
    }

    @Test
    void thePlayerStandsClearOfBodies() {
        assertFree(RoomLevel.hall().cube(new Vec3(0.8, 0.5, 0), 1, 5));
        assertTold(
                RoomLevel.hall().cube(new Vec3(0.7, 0.5, 0), 1, 5),
                "bodies[0].centre the body starts 100 mm deep in the player: move it or player.feet");
        RoomLevel through = portals().startAt(-7.65, 0, 0, 0, 0).cube(new Vec3(0, 1, -7.7), 0.8, 5);
        assertTold(through, "bodies[0].centre the body starts 50 mm deep in the player through a portal");
    }

    @Test
    void aSolidModelIsASolid() {
        String level = "{\"format\": \"nephele-level\", \"version\": 1, \"player\": {\"feet\": [9, 0, 9]},"
                + " \"models\": [{\"id\": \"block\", \"file\": \"box_1_1.3d\"}], \"bodies\": [{\"id\": \"b\","
                + " \"kind\": \"box\", \"centre\": [0, %s, 0], \"size\": [0.2, 0.2, 0.2], \"massKilograms\": 1}]}";
        assertEquals(List.of(), errorsBeforeUse(level(level.formatted("0.6"))));
        List<Problem> problems = errorsBeforeUse(level(level.formatted("0.4")));
        assertEquals(1, problems.size());
        assertTrue(problems.get(0).message().contains("'block'"), problems.toString());
    }

    private static nephele.engine.level.Level level(String json) {
        return LevelJson.read("level", json.getBytes(StandardCharsets.UTF_8));
    }

    @Test
    void aHeapInOnePlaceIsToldInPart() {
        RoomLevel heap = RoomLevel.hall();
        for (int i = 0; i < 3000; i++) {
            heap.cube(new Vec3(3, 3, 0), 1, 5);
        }
        List<String> errors = errors(heap);
        assertEquals(51, errors.size());
        assertEquals("bodies there are more that overlap; these are the first 50", errors.get(50));
    }
}
