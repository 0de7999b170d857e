package nephele.engine.portal.placement;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.Level;
import nephele.engine.level.Problem;
import nephele.engine.level.json.LevelJson;
import nephele.engine.level.placed.NoFiles;
import nephele.engine.level.placed.StaticShapes;
import org.junit.jupiter.api.Test;

/** The rules for fixed portals, in a wall of 4 m by 3 m with its face in the plane z = 0. */
class FixedPortalRulesTest {
    private static final String WALL = "{\"id\": \"wall\", \"kind\": \"box\", \"centre\": [0, 1.5, -0.5], \"size\":"
            + " [4, 3, 1], \"portalable\": true, \"faces\": {\"-z\": {\"portalable\": false}}}";

    private static List<String> toldOfModel(String solids, String models, String... portals) {
        String json = "{\"format\": \"nephele-level\", \"version\": 1, \"solids\": [" + solids + "], \"models\": ["
                + models + "], \"portals\": [" + String.join(",", portals) + "]}";
        Level level = LevelJson.read("level", json.getBytes(StandardCharsets.UTF_8));
        List<Problem> problems = new ArrayList<>();
        FixedPortalRules.AS_INTENDED.check().apply(level, null, StaticShapes.of(level, NoFiles.AT_ALL), problems::add);
        assertTrue(problems.stream().noneMatch(Problem::isError));
        return problems.stream()
                .map(problem -> problem.path() + " " + problem.message())
                .toList();
    }

    private static List<String> told(String solids, String... portals) {
        return toldOfModel(solids, "", portals);
    }

    private static String portal(String id, double x, double y, double z, int normalZ) {
        return "{\"id\": \"" + id + "\", \"linkedTo\": \"x\", \"centre\": [" + x + ", " + y + ", " + z
                + "], \"normal\": [0, 0, " + normalZ + "], \"widthMetres\": 1, \"heightMetres\": 2, \"shape\":"
                + " \"rectangle\"}";
    }

    private static String box(String id, String centre, String size) {
        return ",{\"id\": \"" + id + "\", \"kind\": \"box\", \"centre\": " + centre + ", \"size\": " + size + "}";
    }

    private static void assertTold(List<String> told, String start) {
        assertEquals(1, told.size(), told.toString());
        assertTrue(told.get(0).startsWith(start), told.toString());
    }

    @Test
    void sideBySideOnTheWallIsFine() {
        assertEquals(List.of(), told(WALL, portal("a", -0.5, 1, 0, 1), portal("b", 0.5, 2, 0, 1)));
        assertEquals(List.of(), told(WALL, portal("a", 1.5, 2, 0, 1)));
    }

    @Test
    void oneOnTheOtherIsSaid() {
        assertTold(
                told(WALL, portal("a", -0.5, 1, 0, 1), portal("b", 0.49, 1, 0, 1)),
                "portals[1].centre overlaps portals[0] ('a') in the same plane: where both are, the player sees ");
        assertEquals(List.of(), told("", portal("a", 0, 1, 0, 1), portal("b", 0, 1, 0, -1)));
        assertEquals(List.of(), told("", portal("a", 0, 1, 0, 1), portal("b", 0, 1, 0.1, 1)));
    }

    @Test
    void overAnEdgeIsSaidHowFar() {
        assertTold(
                told(WALL, portal("a", 1.6, 1, 0, 1)),
                "portals[0].centre reaches 100 mm or more over the edge of its surface: the player sees an opening");
        assertEquals(List.of(), told(WALL, portal("a", 5, 1, 0, 1)), "free space is told by another rule");
    }

    /** Abutting faces are one surface, also those of different solids. */
    @Test
    void theNextSolidsFaceGoesOn() {
        String next = box("next", "[3, 1.5, -0.5]", "[2, 3, 1]");
        assertEquals(List.of(), told(WALL + next, portal("a", 2, 1, 0, 1)));
        String apart = box("apart", "[3.01, 1.5, -0.5]", "[2, 3, 1]");
        assertTold(told(WALL + apart, portal("a", 2, 1, 0, 1)), "portals[0].centre reaches 10 mm or more");
        String behind = box("behind", "[3, 1.5, -0.502]", "[2, 3, 1]");
        assertTold(told(WALL + behind, portal("a", 2, 1, 0, 1)), "portals[0].centre reaches 500 mm");
    }

    @Test
    void aMeshIsASurfaceToo() {
        String plane = "{\"id\": \"m\", \"file\": \"plane_4_8.3d\", \"transform\": [{\"kind\": \"rotate\", \"axis\":"
                + " [1, 0, 0], \"angleDegrees\": 90}]}";
        assertEquals(List.of(), toldOfModel("", plane, portal("a", 1.5, -1, 0, 1)));
        assertTold(toldOfModel("", plane, portal("a", 1.7, -1, 0, 1)), "portals[0].centre reaches 200 mm");
    }

    @Test
    void aFaceThatSaysNoIsNamed() {
        assertTold(
                told(WALL, portal("a", 0, 1, -1, -1)),
                "portals[0].centre lies on solids[0].faces.-z, which says that it takes no portals");
    }

    @Test
    void whatHidesItIsNamed() {
        String portal = portal("a", 0, 1, 0, 1);
        assertTold(
                told(WALL + box("plate", "[0, 1, 0.05]", "[2, 1, 0.1]"), portal),
                "portals[0].centre solids[1] ('plate') stands before it: the player sees that instead");
        assertTold(
                told(WALL + box("post", "[0.4, 1, 0.1]", "[0.1, 2, 0.19]"), portal),
                "portals[0].centre solids[1] ('post') stands before a part of it");
        assertEquals(List.of(), told(WALL + box("far", "[0, 1, 0.1]", "[2, 1, 0.1]"), portal), "five centimetres off");
        assertEquals(List.of(), told(WALL + box("step", "[0, 0, 0.1]", "[2, 0.08, 0.2]"), portal), "a doorstep");
    }
}
