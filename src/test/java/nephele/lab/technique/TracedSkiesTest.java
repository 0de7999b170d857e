package nephele.lab.technique;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

final class TracedSkiesTest {
    private static final int FEW_SAMPLES = 2;
    private static final int SOME_SAMPLES = 32;

    private static final double NOT_SHIPPED = 0.31;

    @TempDir
    Path folder;

    @Test
    void whatWasTracedIsReadAgain() throws IOException {
        Path file = folder.resolve(TracedSkies.FILE);
        SkyView sky = node(NOT_SHIPPED, 30).sky();
        TracedSky traced = TracedSkies.in(file).of(sky, FEW_SAMPLES);
        TracedSky read = TracedSkies.in(file).of(sky, FEW_SAMPLES);
        assertArrayEquals(traced.cloudy(), read.cloudy());
        float greatest = 0;
        for (float value : traced.first().rgb()) {
            greatest = Math.max(greatest, value);
        }
        assertArrayEquals(traced.first().rgb(), read.first().rgb(), 1e-4f * greatest);
        assertArrayEquals(traced.second().rgb(), read.second().rgb(), 1e-4f * greatest);
        assertEquals(1, Files.readAllLines(file).size());
    }

    @Test
    void fewerSamplesThanWantedAreTracedAgain() throws IOException {
        Path file = folder.resolve(TracedSkies.FILE);
        SkyView sky = node(NOT_SHIPPED, 30).sky();
        TracedSkies.in(file).of(sky, FEW_SAMPLES);
        TracedSkies.in(file).of(sky, 2 * FEW_SAMPLES);
        assertEquals(2, Files.readAllLines(file).size());
    }

    @Test
    void anotherDepthPlaceOrSunIsAnotherSky() {
        String key = TracedSkies.key(node(4, 30).sky());
        assertEquals(key, TracedSkies.key(node(4, 30).sky()));
        assertNotEquals(key, TracedSkies.key(node(4.001, 30).sky()));
        assertNotEquals(key, TracedSkies.key(node(4, 5).sky()));
        TableCase at = node(4, 30);
        var lowSun = new TableCase(at.cloud(), at.assets(), 4, 30, 6);
        assertNotEquals(key, TracedSkies.key(lowSun.sky()));
    }

    /** Fails if the tracer, a sample or the meaning of a level has changed: then the file is to be made again. */
    @Test
    void aShippedPictureIsWhatIsTracedToday() {
        SkyView sky = node("volume image", 40, 30).sky();
        TracedSky shipped = TracedSkies.shipped().of(sky, SOME_SAMPLES);
        TracedSky today = TracedSky.of(sky, SOME_SAMPLES);
        assertNotEquals(today.mean(), shipped.mean(), "it was not shipped");
        assertEquals(1, today.mean() / shipped.mean(), 0.03);
        assertEquals(0, meanOfDifferences(today, shipped) / shipped.mean(), 0.1);
    }

    private static double meanOfDifferences(TracedSky a, TracedSky b) {
        double sum = 0;
        for (int i = 0; i < a.first().rgb().length; i++) {
            double first = a.first().rgb()[i] + a.second().rgb()[i];
            double second = b.first().rgb()[i] + b.second().rgb()[i];
            sum += a.cloudy()[i / 3] ? Math.abs(first - second) / 2 : 0;
        }
        return sum / (3 * a.size());
    }

    /** A heap of puffs under a high sun. */
    private static TableCase node(double opticalDepth, double angularDegrees) {
        return node("volume puffs", opticalDepth, angularDegrees);
    }

    private static TableCase node(String form, double opticalDepth, double angularDegrees) {
        return TableCase.at(angularDegrees, 45, opticalDepth).stream()
                .filter(at -> at.form().equals(form))
                .findFirst()
                .orElseThrow();
    }
}
