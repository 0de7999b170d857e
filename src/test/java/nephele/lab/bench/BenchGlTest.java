package nephele.lab.bench;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Map;
import nephele.engine.measure.FrameTimes;
import nephele.engine.render.gl.GlContext;
import org.junit.jupiter.api.Test;

class BenchGlTest {
    /** A drawing that only counts: three frames a round, 10 draws in the first of them. */
    private static final class Counting implements Drawing {
        private int frame;
        private byte[] rubbish;

        @Override
        public int roundLength() {
            return 3;
        }

        @Override
        public void draw(int newFrame) {
            frame = newFrame;
            rubbish = new byte[1000];
        }

        @Override
        public long draws(GlContext gl) {
            return frame == 0 ? 10 : 1;
        }

        @Override
        public long triangles(GlContext gl) {
            return rubbish.length;
        }

        @Override
        public void close() {
            rubbish = null;
        }
    }

    @Test
    void roundsAreWholeAndMeansAreOverAllOfThem() {
        try (var gl = GlContext.offscreen();
                var drawing = new Counting()) {
            var times = new Bench(gl, 0.05).measure(drawing);
            assertEquals(0, times.frames() % 3);
            assertEquals(4, times.draws());
            assertEquals(1000, times.triangles());
            assertEquals(1016, times.allocatedBytesPerFrame(), 8);
            assertTrue(times.wallMsP50() <= times.wallMsP95());
            assertTrue(times.cpuMsMean() > 0);
        }
    }

    @Test
    void percentilesAreNearestRanks() {
        long[] nanos = {5_000_000, 1_000_000, 3_000_000, 2_000_000, 4_000_000, 99};
        assertEquals(3, FrameTimes.percentileMs(nanos, 5, 0.5));
        assertEquals(5, FrameTimes.percentileMs(nanos, 5, 0.95));
        assertEquals(1, FrameTimes.percentileMs(nanos, 5, 0));
    }

    @Test
    void aLineHasAValueForEveryColumn() {
        var line = new FrameTimes(60, 12.3456, 6, 7, 1, 6049.25, 336).csv();
        assertEquals("60,12.346,6.000,7.000,1,6049.3,336", line);
        assertEquals(FrameTimes.HEADER.split(",").length, line.split(",").length);
    }

    @Test
    void aRowTellsTheDearestPassesFirstAndLeavesOutWhatCostsNothing() {
        var costs = new PassCosts("clock", Map.of("clouds", 60.0, "solid", 39.0, "exit", 1.0));
        assertEquals(
                "| 05.json | main | low | 50.0 | clouds 30.0, solid 19.5 |", costs.row("05.json", "main", "low", 0.5));
        assertEquals(
                costs.row("", "", "", 1).split("\\|").length,
                PassCosts.TABLE_HEADER.lines().findFirst().orElseThrow().split("\\|").length);
    }

    @Test
    void theYardstickIsOneDraw() {
        try (var gl = GlContext.offscreen();
                var drawing = new CalibrationDrawing(gl, 64, 36)) {
            drawing.draw(0);
            assertEquals(1, drawing.draws(gl));
            gl.requireNoError("calibration");
        }
    }
}
