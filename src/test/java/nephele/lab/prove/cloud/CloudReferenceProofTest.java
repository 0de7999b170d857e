package nephele.lab.prove.cloud;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.math.Ray;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Parts of three clouds look as in Mitsuba's pictures, with 64 samples a pixel. */
class CloudReferenceProofTest {
    @ParameterizedTest
    @CsvSource({
        "sphere, 70, 85",
        "sphere, 40, 50",
        "sphere, 100, 30",
        "puff, 70, 60",
        "puff, 30, 40",
        "puff, 95, 80",
        "cumulus, 70, 60",
        "cumulus, 55, 50",
        "cumulus, 90, 60"
    })
    void aTileIsThatOfTheReference(String name, int left, int bottom) {
        ReferenceCase scene = ReferenceCase.named(name);
        TracedTile tile = new TracedTile(scene, left, bottom, 20, 15).trace(2, 1);
        var comparison = new TileComparison(scene, tile);
        assertTrue(comparison.cloudy() > 100, "cloudy pixels: " + comparison.cloudy());
        assertTrue(comparison.differing() <= 1, "differing pixels: " + comparison.differing());
        assertTrue(comparison.spread() < 1.3, "spread: " + comparison.spread());
        for (int channel = 0; channel < 3; channel++) {
            TileComparison.Bias bias = comparison.bias(channel);
            assertTrue(Math.abs(bias.sigmas()) <= 4, bias.toString());
            assertTrue(Math.abs(bias.share()) <= 0.1, bias.toString());
        }
    }

    /** A camera that looks along +z has +x on its left; rows count from below. */
    @ParameterizedTest
    @CsvSource({"sphere", "puff"})
    void thePictureIsOrientedAsDescribed(String name) {
        ReferenceCase scene = ReferenceCase.named(name);
        Ray lowerLeft = scene.ray(0, 0);
        assertTrue(lowerLeft.directionX() > 0 && lowerLeft.directionY() < 0 && lowerLeft.directionZ() > 0);
        Ray middle = scene.ray(80, 60);
        Ray right = scene.ray(160, 60);
        double cosine = middle.directionX() * right.directionX()
                + middle.directionY() * right.directionY()
                + middle.directionZ() * right.directionZ();
        assertEquals(20, Math.toDegrees(Math.acos(cosine)), 1e-9);
    }
}
