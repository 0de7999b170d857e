package nephele.workshop.prove.picture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.util.List;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.reference.TracedLevel;
import nephele.engine.scene.View;
import nephele.host.draw.IdLevel;
import nephele.host.named.LevelName;
import nephele.workshop.prove.proof.Proof;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** The proof {@code portal-ids} holds for two cameras of each level: one at a portal, one along a wall. */
class PortalIdsProofGlTest {
    static List<String> levels() {
        return ComparedLevel.files();
    }

    @ParameterizedTest
    @MethodSource("levels")
    void noPixelShowsAnotherSurface(String level) throws Exception {
        var result = new PortalIdsProof(List.of(level)).run(3, 2, Proof.Progress.NONE);
        assertEquals(2, result.units());
        assertEquals(List.of(), result.examples());
    }

    /** Former errors do not recur: a view five portals deep was missing; a portal showed the inside of its wall. */
    @ParameterizedTest
    @CsvSource({"edge-to-edge, 26", "portal-on-soup, 0", "portal-on-soup, 17"})
    void noPixelShowsAnotherSurfaceAgain(String sample, int camera) throws Exception {
        var proof = new PortalIdsProof(List.of("levels/samples/" + sample + ".json"));
        assertEquals(List.of(), proof.run(camera, 1, Proof.Progress.NONE).examples());
    }

    /**
     * A missing view is not an edge: if every view was to be drawn it is a failure, else it counts as a fraction of the
     * picture.
     */
    @Test
    void aMissingViewIsAFailureUnlessTheBudgetLeftIt() {
        var opened = new LevelName("levels/samples/solid-box.json").open();
        var traced = TracedLevel.of(opened.placed().edited(IdLevel.of(opened.level())), ColourDecoding.AS_STORED);
        View view = View.ofCamera(opened.level().cameras().get(0), 0, 2);
        var sight = new SightPicture(traced, view, 4, 2);
        var drawn = new BufferedImage(4, 2, BufferedImage.TYPE_INT_RGB);
        for (int i = 0; i < 8; i++) {
            drawn.setRGB(i % 4, 1 - i / 4, i < 6 ? sight.at(i % 4, i / 4) : IdTally.TERMINAL);
        }
        var all = new IdTally();
        all.compare(drawn, sight, ComparedLevel.UNLIMITED, "all");
        assertEquals(
                List.of("all: 2 pixels of views that were not drawn"),
                all.result(1).examples());
        var budgeted = new IdTally();
        budgeted.compare(drawn, sight, 16, "budgeted");
        assertEquals(List.of(), budgeted.result(1).examples());
        assertEquals(
                25,
                budgeted.result(1).figures().stream()
                        .filter(figure -> figure.unit().equals("%"))
                        .findFirst()
                        .orElseThrow()
                        .value());
    }

    /**
     * An opening's sill is an edge although floor is in front of it and behind it; single pixels show the wall between.
     */
    @Test
    void anOpeningsEdgeIsOneThoughTheSameFloorGoesOnBehindIt() {
        var opened = new LevelName("levels/samples/hall-of-mirrors.json").open();
        var traced = TracedLevel.of(opened.placed().edited(IdLevel.of(opened.level())), ColourDecoding.AS_STORED);
        View view = new SeededCameras(opened.level(), traced, 16.0 / 9).view(30);
        var sight = new SightPicture(traced, view, 320, 180);
        int row = 179 - 57;
        for (int i = 0; i < 9; i++) {
            assertEquals(IdLevel.colour(0), sight.at(79 + i % 3, row - 1 + i / 3));
        }
        assertFalse(sight.isPlain(80, row));
        assertTrue(sight.isPlain(80, row - 2), "floor all around, in front of the opening");
    }

    @Test
    void coloursAreOfTheSurfaces() {
        for (int surface : new int[] {0, 1, 77, 4000}) {
            assertEquals(surface, IdLevel.surface(IdLevel.colour(surface)));
        }
    }
}
