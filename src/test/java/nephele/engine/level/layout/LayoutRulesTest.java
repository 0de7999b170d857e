package nephele.engine.level.layout;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.Level;
import nephele.engine.level.Problem;
import nephele.engine.level.json.LevelJson;
import nephele.engine.level.placed.LevelRule.Stage;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Vec3;
import nephele.engine.rule.LevelRules;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** Each rule on the layout of shapes with levels that have and that have not its problem. */
@Execution(ExecutionMode.CONCURRENT)
class LayoutRulesTest {
    /** A closed room of 8 m × 8 m × 3 m whose walls overlap at their corners. */
    private static final String ROOM =
            box("floor", "0, -0.5, 0", "10, 1, 10") + "," + box("roof", "0, 3.5, 0", "10, 1, 10")
                    + "," + box("west", "-4.5, 1.5, 0", "1, 3, 10") + "," + box("east", "4.5, 1.5, 0", "1, 3, 10") + ","
                    + box("south", "0, 1.5, 4.5", "8, 3, 1");

    private static final String NORTH = box("north", "0, 1.5, -4.5", "8, 3, 1");

    /** The wall with a gap between it and the roof. */
    private static String northUpTo(double metres) {
        return box("north", "0, " + metres / 2 + ", -4.5", "8, " + metres + ", 1");
    }

    private static String box(String id, String centre, String size) {
        return box(id, centre, size, "");
    }

    private static String box(String id, String centre, String size, String more) {
        return "{\"id\": \"" + id + "\", \"kind\": \"box\", \"centre\": [" + centre + "], \"size\": [" + size + "]"
                + more + "}";
    }

    private static final String RED = ", \"material\": \"red\"";

    private static Level level(String solids, String sections) {
        String json = "{\"format\": \"nephele-level\", \"version\": 1, \"materials\": [{\"id\": \"red\"}],"
                + " \"player\": {\"feet\": [0, 0, 0]}, \"solids\": [" + solids + "]" + sections + "}";
        return LevelJson.read("test.json", json.getBytes(StandardCharsets.UTF_8));
    }

    private static List<Problem> problems(String solids, String sections) {
        Level level = level(solids, sections);
        List<Problem> problems = new ArrayList<>();
        StaticShapes statics = StaticShapes.of(level);
        LevelRules.of(Stage.LAYOUT).forEach(rule -> rule.check().apply(level, null, statics, problems::add));
        assertTrue(problems.stream().noneMatch(Problem::isError));
        return problems;
    }

    private static List<String> paths(String solids, String sections) {
        return problems(solids, sections).stream().map(Problem::path).toList();
    }

    private static void assertGood(String solids) {
        assertEquals(List.of(), problems(solids, ""));
    }

    @Test
    void aClosedRoomIsGood() {
        assertGood(ROOM + "," + NORTH);
    }

    @Test
    void aGapLeaksAndTheLineGoesThroughIt() {
        for (double gap : new double[] {0.005, 0.3, 3}) {
            String wall = gap == 3 ? "" : "," + northUpTo(3 - gap);
            Problem leak = problems(ROOM + wall, "").get(0);
            assertEquals("player.feet", leak.path());
            List<Vec3> line = leak.subject().place();
            BrushIndex solids = new BrushIndex(StaticShapes.of(level(ROOM + wall, "")));
            assertEquals(new Vec3(0, 0.9, 0), line.get(0));
            assertTrue(line.get(line.size() - 1).z() <= -5.99, line.toString());
            double metres = 0;
            for (int i = 1; i < line.size(); i++) {
                assertFalse(solids.isBlocked(line.get(i - 1), line.get(i), 2e-3), line.toString());
                metres += line.get(i).minus(line.get(i - 1)).length();
            }
            assertTrue(metres < 8, "not the shortest: " + metres);
            assertTrue(line.size() <= 4, line.toString());
        }
    }

    @Test
    void aGapBelowAMillimetreIsRounding() {
        assertGood(ROOM + "," + northUpTo(3 - 5e-4));
    }

    @Test
    void aSlantedWallClosesARoomToo() {
        String slanted = "{\"id\": \"north\", \"kind\": \"planes\", \"planes\": [{\"normal\": [0, 0.5, 1],"
            + " \"distanceMetres\": -2},{\"normal\": [0, -0.5, -1], \"distanceMetres\": 2.5},{\"normal\": [1, 0, 0],"
            + " \"distanceMetres\": 4}, {\"normal\": [-1, 0, 0], \"distanceMetres\": 4},{\"normal\": [0, 1, 0],"
            + " \"distanceMetres\": %s}, {\"normal\": [0, -1, 0], \"distanceMetres\": 0}]}";
        assertGood(ROOM + "," + String.format(slanted, "3"));
        assertEquals(List.of("player.feet"), paths(ROOM + "," + String.format(slanted, "2"), ""));
    }

    @Test
    void aLevelWithAnOutsideOrWithoutWallsIsOpenOnPurpose() {
        assertEquals(
                List.of(),
                paths(ROOM, ", \"environment\": {\"sky\": {\"kind\": \"constant\", \"radiance\": [1, 1, 1]}}"));
        assertGood(box("floor", "0, -0.5, 0", "10, 1, 10"));
    }

    @Test
    void facesOfTwoMaterialsInOnePlaneFight() {
        String step = ", \"material\": \"red\"";
        String low = box("low", "-2, 0.25, 0", "1, 0.5, 1");
        List<Problem> found =
                problems(ROOM + "," + NORTH + "," + low + "," + box("high", "-2, 0.25, 0.5", "1, 0.5, 1", step), "");
        assertEquals(
                List.of("solids[7].faces.+x", "solids[7].faces.-x", "solids[7].faces.+y"),
                found.stream().map(Problem::path).toList());
        assertEquals(List.of("solids[6].faces.+y"), found.get(2).subject().otherPaths());
        assertEquals(0.5, FacePieces.areaSquareMetres(found.get(2).subject().place()), 1e-9);
        assertGood(ROOM + "," + NORTH + "," + low + "," + box("high", "-2, 0.25, 0.5", "1, 0.5, 1"));
        assertGood(ROOM + "," + NORTH + "," + low + "," + box("high", "-2, 0.251, 0.5", "1.004, 0.502, 1", step));
        assertGood(ROOM + "," + NORTH + "," + low + "," + box("beside", "-1, 0.25, 0", "1, 0.5, 1", step));
    }

    @Test
    void hiddenFacesAndNarrowStripsDoNotFight() {
        String low = box("low", "-2, 0.25, 0", "1, 0.5, 1");
        String high = box("high", "-2, 0.25, 0.5", "1, 0.5, 1", RED);
        String cover = box("cover", "-2, 0.45, 0.25", "2, 1.1, 3");
        assertEquals(
                List.of("solids[6]", "solids[7]"),
                paths(ROOM + "," + NORTH + "," + low + "," + high + "," + cover, ""),
                "both are hidden, which is another problem");
        assertGood(ROOM + "," + NORTH + "," + low + "," + box("trim", "-2, 0.26, 0.99", "1.02, 0.48, 1.02", RED));
    }

    @Test
    void aSolidInsideAnotherHasNoEffectUnlessAFaceShows() {
        String outer = box("outer", "0, 1, 2", "2, 2, 2");
        assertEquals(
                List.of("solids[7]"),
                paths(ROOM + "," + NORTH + "," + outer + "," + box("in", "0, 1, 2", "1, 1, 1"), ""));
        assertEquals(
                List.of("solids[7]"),
                paths(ROOM + "," + NORTH + "," + outer + "," + box("in", "0, 1, 2", "2, 2, 2"), ""),
                "of two equal ones, the second");
        assertEquals(
                List.of(),
                paths(
                        ROOM + "," + NORTH + "," + outer + ","
                                + box("panel", "0, 1, 1.5", "1, 1, 1", ", \"portalable\": true"),
                        ""));
    }

    @Test
    void aSolidThinnerThanTheToleranceIsReported() {
        assertEquals(List.of("solids[6]"), paths(ROOM + "," + NORTH + "," + box("film", "0, 1, 0", "1, 1, 5e-4"), ""));
        assertGood(ROOM + "," + NORTH + "," + box("sheet", "0, 1, 0", "1, 1, 2e-3"));
    }

    private static String light(String position, String more) {
        return ", \"lights\": [{\"id\": \"l\", \"kind\": \"point\", \"position\": [" + position
                + "], \"radiantIntensity\": [1, 1, 1]" + more + "}]";
    }

    @Test
    void aLightReachesSomethingAndIsOutsideSolids() {
        String solids = ROOM + "," + NORTH;
        assertEquals(List.of(), paths(solids, light("0, 2, 0", "")));
        assertEquals(List.of("lights[0].rangeMetres"), paths(solids, light("0, 1.5, 0", ", \"rangeMetres\": 1")));
        assertEquals(List.of("lights[0].position"), paths(solids, light("0, -0.5, 0", "")));
        assertEquals(
                List.of(),
                paths(solids, light("0, -0.5, 0", ", \"castsShadow\": false")),
                "without shadows it shines through");
    }

    @Test
    void aHeapOfProblemsIsReportedBriefly() {
        StringBuilder heap = new StringBuilder(ROOM + "," + NORTH);
        for (int i = 0; i < 80; i++) {
            heap.append(",").append(box("in" + i, "0, -0.5, 0", "0.5, 0.5, 0.5"));
        }
        assertEquals(FirstProblems.MOST + 1, problems(heap.toString(), "").size());
    }
}
