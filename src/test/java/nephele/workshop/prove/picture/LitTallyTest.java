package nephele.workshop.prove.picture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import nephele.engine.measure.LinearPicture;
import nephele.workshop.prove.proof.ProofResult;
import org.junit.jupiter.api.Test;

/** A level is judged by all of its pictures together, regardless of their batches; the pictures are of one grey. */
class LitTallyTest {
    private static final LinearPicture RIGHT = grey(0.2f);
    private static final List<String> LEVELS = List.of("a", "b");

    private static LinearPicture grey(float value) {
        float[] rgb = new float[3 * 16 * 9];
        Arrays.fill(rgb, value);
        return new LinearPicture(16, 9, rgb);
    }

    private static ProofResult batch(String level, int camera, float once, float averaged) {
        var tally = new LitTally();
        tally.compare(level, "camera " + camera, RIGHT, grey(once), grey(averaged));
        return tally.result(1);
    }

    private static ProofResult judged(ProofResult soFar) {
        return LitTally.judged(soFar, LEVELS);
    }

    @Test
    void whatIsDrawnOnceAPixelIsJudgedAndTheAveragedReported() {
        assertTrue(judged(batch("a", 0, 0.2f, 0.4f)).holds());
        var failed = judged(batch("a", 0, 0.4f, 0.2f));
        assertEquals(1, failed.failures());
        String line = failed.examples().get(0);
        assertTrue(line.contains("(0.0000 drawn 2 times as large and averaged), bias +100.00 %"), line);
        assertTrue(line.endsWith("in camera 0"), line);
    }

    @Test
    void batchesOfALevelMakeUpForOneAnother() {
        var bright = batch("a", 0, 0.203f, 0.2f);
        var dark = batch("a", 1, 0.1985f, 0.2f);
        assertEquals(1, judged(bright).failures(), "1.5 % too bright");
        var both = bright.and(batch("b", 0, 0.2f, 0.2f)).and(dark);
        assertEquals(3, both.units());
        assertTrue(judged(both).holds(), "both together 0.4 %");
        assertEquals(3, judged(both).figure("pictures").orElseThrow().value());
    }

    @Test
    void oneLevelDoesNotMakeUpForAnother() {
        var result = judged(batch("b", 0, 0.2f, 0.2f).and(batch("a", 0, 0.205f, 0.2f)));
        assertEquals(1, result.failures());
        assertTrue(
                result.examples().get(0).startsWith("a: mean FLIP"),
                result.examples().get(0));
    }

    @Test
    void theWorstPictureIsNamed() {
        var result =
                judged(batch("a", 0, 0.21f, 0.2f).and(batch("a", 7, 0.3f, 0.2f)).and(batch("a", 9, 0.25f, 0.2f)));
        assertTrue(
                result.examples().get(0).endsWith("in camera 7"),
                result.examples().get(0));
        assertEquals(
                "in camera 7",
                result.figure("greatest mean FLIP of a picture").orElseThrow().unit());
    }
}
