package nephele.engine.portal.placement;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.Level;
import nephele.engine.level.Problem;
import nephele.engine.level.json.LevelJson;
import nephele.engine.level.placed.StaticShapes;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** Reports of portalable surfaces without room for the gun's portals, 1.2 m × 2.1 m. */
@Execution(ExecutionMode.CONCURRENT)
class RoomRulesTest {
    private static final String GUN = ", \"portalGun\": {}";
    private static final String FACE = ", \"faces\": {\"+z\": {\"portalable\": true}}";
    private static final String ALL = ", \"portalable\": true";

    private static List<String> paths(String sections, String... solids) {
        String json = "{\"format\": \"nephele-level\", \"version\": 1, \"solids\": [" + String.join(",", solids) + "]"
                + sections + "}";
        Level level = LevelJson.read("test.json", json.getBytes(StandardCharsets.UTF_8));
        List<Problem> problems = new ArrayList<>();
        RoomRules.LARGE_ENOUGH.check().apply(level, null, StaticShapes.of(level), problems::add);
        return problems.stream().map(Problem::path).toList();
    }

    private static String box(double x, double y, double z, double width, double height, double depth, String more) {
        return "{\"id\": \"b" + x + "," + y + "," + z + "\", \"kind\": \"box\", \"centre\": [" + x + "," + y + "," + z
                + "], \"size\": [" + width + "," + height + "," + depth + "]" + more + "}";
    }

    @Test
    void aMarkedFaceNeedsThePlaceOfAPortal() {
        assertEquals(List.of(), paths(GUN, box(0, 0, 0, 1.2, 2.1, 1, FACE)));
        assertEquals(List.of("solids[0].faces.+z.portalable"), paths(GUN, box(0, 0, 0, 1.19, 2.1, 1, FACE)));
        assertEquals(List.of("solids[0].faces.+z.portalable"), paths(GUN, box(0, 0, 0, 5, 2, 1, FACE)));
    }

    @Test
    void withoutAGunNothingIsTooSmall() {
        assertEquals(List.of(), paths("", box(0, 0, 0, 1, 1, 1, FACE)));
    }

    @Test
    void tilesMakeOneSurface() {
        assertEquals(List.of(), paths(GUN, box(0, 0, 0, 1, 3, 1, FACE), box(1, 0, 0, 1, 3, 1, FACE)));
        assertEquals(
                List.of("solids[0].faces.+z.portalable"),
                paths(GUN, box(0, 0, 0, 0.5, 3, 1, FACE), box(0.5, 0, 0, 0.5, 3, 1, FACE)),
                "one warning for one surface");
    }

    @Test
    void aSolidNeedsOneFaceWithRoom() {
        assertEquals(List.of(), paths(GUN, box(0, 0, 0, 3, 3, 0.1, ALL)));
        assertEquals(List.of("solids[0].portalable"), paths(GUN, box(0, 0, 0, 1, 3, 1, ALL)));
    }

    @Test
    void floorsAreTriedInEveryDirection() {
        String top = ", \"faces\": {\"+y\": {\"portalable\": true}}";
        assertEquals(List.of(), paths(GUN, box(0, 0, 0, 2.2, 1, 1.3, top)));
        assertEquals(List.of(), paths(GUN, box(0, 0, 0, 1.3, 1, 2.2, top)));
        assertEquals(List.of("solids[0].faces.+y.portalable"), paths(GUN, box(0, 0, 0, 2, 1, 1.1, top)));
    }

    @Test
    void whatStandsBeforeASurfaceTakesItsPlace() {
        String wall = box(0, 0, 0, 3, 3, 1, FACE);
        assertEquals(List.of(), paths(GUN, wall, box(1.2, 0, 0.6, 0.2, 3, 0.2, "")));
        assertEquals(
                List.of("solids[0].faces.+z.portalable"),
                paths(GUN, wall, box(0.5, 0, 0.6, 0.2, 3, 0.2, ""), box(-0.8, 0, 0.6, 0.2, 3, 0.2, "")));
    }
}
