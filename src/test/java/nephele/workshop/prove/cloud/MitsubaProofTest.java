package nephele.workshop.prove.cloud;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.joml.Vector3d;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Parts of three levels with a cloud and of four rooms look as in Mitsuba's pictures, with 64 samples a pixel. */
class MitsubaProofTest {
    /** Tiles are numbered from the lower left, ten in a row of a cloud, twelve in one of a room. */
    @ParameterizedTest
    @CsvSource({
        "sphere, 54",
        "sphere, 32",
        "sphere, 44",
        "puff, 34",
        "puff, 21",
        "puff, 45",
        "cumulus, 34",
        "cumulus, 33",
        "cornell, 18",
        "cornell, 53",
        "sunroom, 28",
        "two-rooms, 41",
        "furnace, 5"
    })
    void aTileIsThatOfTheReference(String name, int tile) {
        ReferenceCase scene = ReferenceCase.named(name);
        TracedArea area = TracedArea.tile(scene, tile, 64, 1);
        assertTrue(area.cloudy() > 60, "cloudy pixels: " + area.cloudy());
        assertTrue(area.differing() <= 1, "differing pixels: " + area.differing());
        assertTrue(area.spread() < 1.3, "spread: " + area.spread());
        for (int channel = 0; channel < 3; channel++) {
            assertEquals(0, area.biasSigmas(channel), 4);
            assertEquals(0, area.bias(channel), 0.1);
        }
    }

    /** A camera that looks along +z has +x on its left; rows count from below. */
    @ParameterizedTest
    @CsvSource({"sphere", "puff"})
    void thePictureIsOrientedAsDescribed(String name) {
        ReferenceCase scene = ReferenceCase.named(name);
        Vector3d ahead = scene.eye().basis().back().toVector().negate();
        assertTrue(ahead.z > 0);
        assertTrue(
                scene.eye().basis().right().x() < 0 && scene.eye().basis().up().y() > 0);
        assertEquals(20, Math.toDegrees(Math.atan(scene.eye().halfWidth())), 1e-9);
    }
}
