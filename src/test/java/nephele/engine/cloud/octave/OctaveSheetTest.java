package nephele.engine.cloud.octave;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.level.Cloud;
import nephele.engine.level.CloudTechnique;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class OctaveSheetTest {
    private static final double EVOLUTION = 4;

    private static OctaveSheet sheet(ProceduralNoise kind, double coverage, double meanDepth) {
        var cloud = new Cloud(
                "octaves",
                new Cloud.Extent.Layer(1000, 300),
                CloudTechnique.PROCEDURAL,
                new Cloud.Density.Noise(77, 600, coverage),
                0.02,
                1,
                0.85,
                new Cloud.Motion(Vec3.ZERO, EVOLUTION));
        return OctaveSheet.of(cloud, kind, 300, meanDepth);
    }

    @ParameterizedTest
    @EnumSource
    void coverageAndMeanDepthAreTheClouds(ProceduralNoise kind) {
        for (double coverage : new double[] {0.2, 0.5, 0.9}) {
            OctaveSheet sheet = sheet(kind, coverage, 2.5);
            int covered = 0;
            int across = 250;
            for (int n = 0; n < across * across; n++) {
                covered += sheet.at(777.7 * (n % across) - 31, 777.7 * (n / across) + 55, 0) > 0 ? 1 : 0;
            }
            assertEquals(coverage, covered / (double) (across * across), 0.02);
            assertEquals(2.5, meanDepth(sheet, 0), 0.15);
        }
    }

    private static double meanDepth(OctaveSheet sheet, double seconds) {
        double sum = 0;
        int across = 250;
        for (int n = 0; n < across * across; n++) {
            sum += sheet.at(777.7 * (n % across) - 31, 777.7 * (n / across) + 55, seconds);
        }
        return sheet.greatestDepth() * sum / (across * across);
    }

    /** Half-way between two pictures a linear cross-fade has half the variance, and clouds thin out; the smooth one's stay. */
    @Test
    void onlyTheSourcesCloudsPulse() {
        assertEquals(2.5, meanDepth(sheet(ProceduralNoise.SMOOTH, 0.5, 2.5), EVOLUTION / 2), 0.15);
        assertEquals(1.9, meanDepth(sheet(ProceduralNoise.SOURCE, 0.5, 2.5), EVOLUTION / 2), 0.3);
    }

    @Test
    void withoutCoverageThereIsNothing() {
        OctaveSheet sheet = sheet(ProceduralNoise.SMOOTH, 0, 0);
        assertEquals(0, sheet.greatestDepth());
    }

    /** The source's noise renews a picture each 4, 2 and 1 s and repeats in space; the smooth one does neither. */
    @Test
    void onlyTheSourcesNoiseRepeats() {
        double period = 32 * 1200;
        OctaveSheet source = sheet(ProceduralNoise.SOURCE, 0.5, 1);
        OctaveSheet smooth = sheet(ProceduralNoise.SMOOTH, 0.5, 1);
        double moved = 0;
        for (int i = 0; i < 100; i++) {
            assertEquals(source.at(313 * i, 211 * i, 9.25), source.at(313 * i + period, 211 * i - period, 9.25), 1e-9);
            moved += Math.abs(smooth.at(313 * i, 211 * i, 9.25) - smooth.at(313 * i + period, 211 * i - period, 9.25));
        }
        assertTrue(moved / 100 > 0.05, "mean change " + moved / 100);
    }

    @Test
    void theSourcesHashIsEliasS() {
        int n = 3 + 57 * 5 + 131 * 2;
        n = n << 13 ^ n;
        double expected = 1.0 - (n * (n * n * 15731 + 789221) + 1376312589 & 0x7fffffff) / 1073741824.0;
        assertEquals(expected, NoiseOctave.white(3, 5, 2));
    }

    /** Neither a place's nor a moment's value jumps: between generations, cells, and 30 days later. */
    @ParameterizedTest
    @EnumSource
    void valuesChangeGradually(ProceduralNoise kind) {
        OctaveSheet sheet = sheet(kind, 0.6, 1);
        double month = 30 * 86400;
        for (int i = 0; i < 2000; i++) {
            double x = 1e6 + 600 * i;
            double now = sheet.at(x, -x, month + 0.01 * i);
            assertEquals(now, sheet.at(x + 0.01, -x, month + 0.01 * i), 1e-3);
            assertEquals(now, sheet.at(x, -x, month + 0.01 * i + 1e-5), 1e-3);
        }
    }
}
