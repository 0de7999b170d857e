package nephele.workshop.prove.picture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.util.List;
import nephele.engine.measure.ColourVision;
import nephele.workshop.prove.proof.Proof;
import org.junit.jupiter.api.Test;

/** Runs the proof {@code standing-out} over one sight of each sign of a sample, and checks its measure. */
class StandingOutProofGlTest {
    @Test
    void exitsAndPortalsOfASampleStandOut() throws Exception {
        var proof = new StandingOutProof(List.of("levels/samples/exits.json"), null);
        var result = proof.run(0, 1, Proof.Progress.NONE);
        assertEquals(0, result.failures(), result.examples().toString());
        assertTrue(result.value("signs seen") >= 6, result.figures().toString());
    }

    /** A grey square on white, by hand: L* 100 and 53.6, the same for every vision; a red one is dark in protanopia. */
    @Test
    void theContrastIsThatOfLightness() {
        double[] grey = contrast(0x808080, 30);
        for (double vision : grey) {
            assertEquals(100 - 53.585, vision, 0.01);
        }
        double[] red = contrast(0xff0000, 30);
        assertEquals(100 - 53.241, red[ColourVision.NORMAL.ordinal()], 0.01);
        assertTrue(red[ColourVision.PROTANOPIA.ordinal()] > 55, "red is dark without red cones");
        assertNull(contrast(0xfffffe, 30), "a sign that nobody sees is none");
        assertNull(contrast(0x808080, 90), "most of it is hidden");
    }

    private static double[] contrast(int rgb, double reach) {
        var without = new BufferedImage(64, 64, BufferedImage.TYPE_INT_RGB);
        var with = new BufferedImage(64, 64, BufferedImage.TYPE_INT_RGB);
        for (int i = 0; i < 64 * 64; i++) {
            boolean isSign = Math.abs(i % 64 - 32) < 10 && Math.abs(i / 64 - 32) < 10;
            without.setRGB(i % 64, i / 64, 0xffffff);
            with.setRGB(i % 64, i / 64, isSign ? rgb : 0xffffff);
        }
        return new SignContrast(64, 64, 12).of(with, without, 32, 32, reach);
    }
}
