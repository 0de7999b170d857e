package nephele.engine.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Level;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.frame.Quality.Antialiasing;
import nephele.engine.render.frame.ToneMapping;
import nephele.engine.render.pass.edge.LineArea;
import nephele.engine.scene.Projection;
import nephele.engine.scene.View;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The filter of the displayed picture smooths stairs towards the picture with many samples, and nothing else. */
class EdgeFilterGlTest {
    private static final int SIZE = 96;
    private static final int TIMES = 8;

    private static Level square() {
        return new TestLevel()
                .ambient(1)
                .material("white", TestLevel.grey(0.8))
                .box("white", new Vec3(0, 0, -0.5), new Vec3(2, 2, 1))
                .level();
    }

    /** Looks at the square with its edges inclined. */
    private static View turned(double degrees) {
        double radians = Math.toRadians(degrees);
        return View.lookAt(
                new Vec3(0, 0, 2.2),
                Vec3.ZERO,
                new Vec3(Math.sin(radians), Math.cos(radians), 0),
                new Projection(Math.PI / 2, 1, 0.05, 1000));
    }

    private static RenderSettings settings(Antialiasing filter) {
        return RenderSettings.of(Output.PLAIN, Quality.HIGH.inOneFrame().with("antialiasing", filter));
    }

    private static double linear(int pixel) {
        return ToneMapping.decodeSrgb(Offscreen.red(pixel) / 255.0);
    }

    private static double rms(int[] picture, double[] exact) {
        double sum = 0;
        for (int i = 0; i < exact.length; i++) {
            sum += Math.pow(linear(picture[i]) - exact[i], 2);
        }
        return Math.sqrt(sum / exact.length);
    }

    private static double[] exact(View view) {
        int side = SIZE * TIMES;
        double[] mean = new double[SIZE * SIZE];
        try (var offscreen = new Offscreen(side, side)) {
            int[] many = offscreen.pixels(square(), TestAssets.NONE, view, settings(Antialiasing.NONE));
            for (int i = 0; i < many.length; i++) {
                mean[i / side / TIMES * SIZE + i % side / TIMES] += linear(many[i]) / (TIMES * TIMES);
            }
        }
        return mean;
    }

    /** Against 64 samples a pixel; outside of the edges nothing differs, so this is the error at them. */
    @ParameterizedTest
    @CsvSource({"4, 0.65", "9, 0.65", "20, 0.65", "33, 0.65", "45, 0.85"})
    void inclinedEdgesAreNearerToManySamples(double degrees, double most) {
        View view = turned(degrees);
        double[] exact = exact(view);
        try (var offscreen = new Offscreen(SIZE, SIZE)) {
            double without = rms(offscreen.pixels(square(), TestAssets.NONE, view, settings(Antialiasing.NONE)), exact);
            double with =
                    rms(offscreen.pixels(square(), TestAssets.NONE, view, settings(Antialiasing.MORPHOLOGICAL)), exact);
            assertTrue(with <= most * without, with + " of " + without);
        }
    }

    @Test
    void areasEqualTheTwin() {
        float[] in = new float[4 * 17 * 17 * 9];
        int at = 0;
        for (int i = 0; i < 17 * 17; i++) {
            for (int ends = 0; ends < 9; ends++) {
                in[at++] = i % 17;
                in[at++] = i / 17;
                in[at++] = ends % 3 - 1;
                in[at++] = ends / 3 - 1;
            }
        }
        float[] gpu = TwinProgram.run("line-area.frag", in, in.length / 4, uniforms -> {});
        for (int i = 0; i < in.length / 4; i++) {
            double exact = LineArea.beyond(in[4 * i], in[4 * i + 1], in[4 * i + 2], in[4 * i + 3]);
            assertEquals(exact, gpu[3 * i], 1e-6);
        }
    }

    @Test
    void straightEdgesStayAsTheyAre() {
        try (var offscreen = new Offscreen(SIZE, SIZE)) {
            assertArrayEquals(
                    offscreen.pixels(square(), TestAssets.NONE, turned(0), settings(Antialiasing.NONE)),
                    offscreen.pixels(square(), TestAssets.NONE, turned(0), settings(Antialiasing.MORPHOLOGICAL)));
        }
    }

    /** The first frame is as good as the later ones, at every size. */
    @ParameterizedTest
    @ValueSource(ints = {1, 7, 64})
    void everySizeIsDrawnTheSameAgain(int size) {
        try (var offscreen = new Offscreen(size, size);
                var renderer = LevelRenderer.load(
                        offscreen.gl, square(), TestAssets.NONE, settings(Antialiasing.MORPHOLOGICAL))) {
            renderer.draw(turned(20), offscreen.picture);
            int[] first = offscreen.pixels();
            assertTrue(Offscreen.red(first[size / 2 * size + size / 2]) > 40);
            renderer.draw(turned(20), offscreen.picture);
            assertArrayEquals(first, offscreen.pixels());
            assertEquals(
                    1,
                    renderer.stepNames().stream().filter("edge-filter"::equals).count());
        }
    }
}
