package nephele.engine.cloud;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.asset.TestAssets;
import nephele.engine.choice.CloudExplanation;
import nephele.engine.level.Level;
import nephele.engine.level.json.LevelJsonTest;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.rule.LevelRules;
import org.junit.jupiter.api.Test;

/** The error of a skybox of a cloud, how it is told, and where it is warned of. */
class SkyboxParallaxTest {
    private static final String PLAYER = "'player': {'feet': [0, 0, 0]}";
    /** A room of 4 m × 4 m, and a tower elsewhere. */
    private static final String ROOM = PLAYER + ", 'solids': [" + box("floor", "0, -0.5, 0", "6, 1, 6") + ", "
            + box("roof", "0, 3.5, 0", "6, 1, 6") + ", " + box("west", "-2.5, 1.5, 0", "1, 3, 6") + ", "
            + box("east", "2.5, 1.5, 0", "1, 3, 6") + ", " + box("south", "0, 1.5, 2.5", "6, 3, 1") + ", "
            + box("north", "0, 1.5, -2.5", "6, 3, 1") + ", " + box("tower", "0, 250, 90", "2, 500, 2") + "]";

    private static String box(String id, String centre, String size) {
        return "{'id': '%s', 'kind': 'box', 'centre': [%s], 'size': [%s]}".formatted(id, centre, size);
    }

    private static Level level(String sections) {
        return LevelJsonTest.sections(sections.replace("'", "\""));
    }

    private static Level under(String centre) {
        return level(ROOM
                + ", 'environment': {'clouds': [{'id': 'far', 'kind': 'volume', 'technique': 'skybox', 'centre': [%s],"
                        .formatted(centre)
                + " 'size': [20, 20, 20]}]}");
    }

    @Test
    void theErrorIsThatOfAPinholeCamera() {
        var parallax = new SkyboxParallax(12, 1000);
        assertEquals(640 * Math.tan(Math.atan2(12, 1000)), parallax.pixels(640), 1e-12);
        assertFalse(parallax.isInside());
        assertTrue(new SkyboxParallax(12, 0).isInside());
        assertEquals(Double.POSITIVE_INFINITY, new SkyboxParallax(12, 0).pixels(640));
    }

    @Test
    void focalLengthsAreThoseOfTheFirstCameraElseOfThePlayer() {
        String at = "'cameras': [{'id': 'a', 'position': [0, 0, 0], 'target': [0, 0, -1]";
        assertEquals(640, SkyboxParallax.focalPixels(level(at + "}]")), 1e-9);
        assertEquals(360, SkyboxParallax.focalPixels(level(at + ", 'verticalFovDegrees': 90}]")), 1e-9);
        assertEquals(360 / Math.tan(Math.PI / 6), SkyboxParallax.focalPixels(level(PLAYER)), 1e-9);
    }

    private static String explained(String centre) {
        return CloudExplanation.lines(PlacedLevel.of(under(centre), TestAssets.NONE))
                .get(0);
    }

    @Test
    void theErrorIsExplained() {
        String words = "clouds: far by technique skybox: because technique is written; ";
        String far = explained("0, 0, -1100");
        assertTrue(
                far.matches(words
                        + "[12][.]\\d+ pixels of parallax for an eye that moves [23][.]\\d+ m [(]1280 pixels wide[)];"
                        + " no surface can be in it"),
                far);
        assertEquals(words + "wrong, since an eye can be in it on foot", explained("0, 0, 3"));
    }

    private static List<String> warnings(String centre) {
        return LevelRules.check(under(centre), TestAssets.NONE).stream()
                .filter(problem -> problem.path().endsWith(".technique"))
                .map(problem -> problem.path() + ": " + problem.message().substring(0, 28))
                .toList();
    }

    @Test
    void whatCannotBeRightIsWarnedOf() {
        assertEquals(List.of(), warnings("0, 0, -1100"));
        assertEquals(List.of("environment.clouds[0].technique: an eye can be in this cloud "), warnings("0, 0, 3"));
        assertEquals(List.of("environment.clouds[0].technique: a solid reaches into this cl"), warnings("0, 300, 90"));
    }
}
