package nephele.engine.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.engine.asset.TestAssets;
import nephele.engine.level.Level;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.frame.Quality.EdgeFilter;
import nephele.engine.render.frame.Quality.Upscale;
import nephele.engine.scene.Projection;
import nephele.engine.scene.View;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** Pictures drawn with fewer pixels and scaled up. */
class UpscaleGlTest {
    private static final View AHEAD =
            View.lookAt(new Vec3(0, 0, 1.5), Vec3.ZERO, new Vec3(0, 1, 0), new Projection(Math.PI / 2, 1, 0.05, 1000));

    /** A white square; its sides are at 1/6 and 5/6 of the picture. */
    private static Level square() {
        return new TestLevel()
                .ambient(1)
                .material("white", TestLevel.grey(1))
                .box("white", new Vec3(0, 0, -0.5), new Vec3(2, 2, 1))
                .level();
    }

    private static RenderSettings settings(Output output, double resolution, Upscale filter) {
        return RenderSettings.of(
                output, Quality.HIGH.withPictureResolution(resolution).withUpscale(filter));
    }

    @ParameterizedTest
    @EnumSource(Upscale.class)
    void flatAreasAndEdgesStayWhereTheyAre(Upscale filter) {
        try (var offscreen = new Offscreen(96, 96)) {
            int[] whole = offscreen.pixels(square(), TestAssets.NONE, AHEAD, settings(Output.PLAIN, 1, filter));
            int[] scaled = offscreen.pixels(square(), TestAssets.NONE, AHEAD, settings(Output.PLAIN, 0.5, filter));
            long sum = 0;
            for (int i = 0; i < whole.length; i++) {
                int difference = Offscreen.red(scaled[i]) - Offscreen.red(whole[i]);
                sum += difference;
                int fromEdge = Math.min(
                        Math.min(Math.abs(i % 96 - 16), Math.abs(i % 96 - 80)),
                        Math.min(Math.abs(i / 96 - 16), Math.abs(i / 96 - 80)));
                if (fromEdge > 5) {
                    assertEquals(0, difference, "pixel " + i % 96 + ", " + i / 96);
                }
            }
            // A shift by half a pixel would leave 255 a pixel along the square's 64 rows, or half that.
            assertEquals(0, sum / 64.0, 12);
        }
    }

    /**
     * The scaled picture equals the small one, drawn for itself and interpolated in double precision by all sixteen
     * weights; the shader omits the corner ones, which are below half a percent each.
     */
    @ParameterizedTest
    @CsvSource({"BILINEAR, 1", "CATMULL_ROM, 3"})
    void filtersEqualTheirTwins(Upscale filter, int most) {
        View slanted = View.lookAt(
                new Vec3(0.2, 0.1, 1.5), Vec3.ZERO, new Vec3(0.3, 1, 0), new Projection(Math.PI / 2, 1, 0.05, 1000));
        int[] small;
        try (var offscreen = new Offscreen(32, 32)) {
            small = offscreen.pixels(square(), TestAssets.NONE, slanted, settings(Output.PLAIN, 1, filter));
        }
        try (var offscreen = new Offscreen(64, 64)) {
            int[] scaled = offscreen.pixels(square(), TestAssets.NONE, slanted, settings(Output.PLAIN, 0.5, filter));
            for (int i = 0; i < scaled.length; i++) {
                double exact = interpolated(small, (i % 64 + 0.5) / 2 - 0.5, (i / 64 + 0.5) / 2 - 0.5, filter);
                assertEquals(exact, Offscreen.red(scaled[i]), most, "pixel " + i % 64 + ", " + i / 64);
            }
        }
    }

    private static double interpolated(int[] small, double x, double y, Upscale filter) {
        double sum = 0;
        for (int row = -1; row <= 2; row++) {
            for (int column = -1; column <= 2; column++) {
                int texelX = (int) Math.floor(x) + column;
                int texelY = (int) Math.floor(y) + row;
                int texel = small[32 * Math.max(0, Math.min(31, texelY)) + Math.max(0, Math.min(31, texelX))];
                sum += weight(x - texelX, filter) * weight(y - texelY, filter) * Offscreen.red(texel);
            }
        }
        return Math.max(0, Math.min(255, sum));
    }

    private static double weight(double distance, Upscale filter) {
        double d = Math.abs(distance);
        if (filter == Upscale.BILINEAR) {
            return Math.max(0, 1 - d);
        }
        return d < 1 ? 1 + d * d * (1.5 * d - 2.5) : d < 2 ? 2 + d * (-4 + d * (2.5 - 0.5 * d)) : 0;
    }

    /** A level whose picture is one colour is drawn by a clear alone; nothing is scaled or filtered. */
    @Test
    void theEmptyLevelIsOneClearAtEveryQuality() {
        var settings = RenderSettings.of(Output.PLAIN, Quality.LOW.withEdgeFilter(EdgeFilter.MORPHOLOGICAL));
        try (var offscreen = new Offscreen(8, 8);
                var renderer = Renderer.load(offscreen.gl, new TestLevel().level(), TestAssets.NONE, settings)) {
            assertEquals(List.of("clear"), renderer.stepNames());
        }
    }

    @Test
    void resolutionOneHasNoStepMore() {
        try (var offscreen = new Offscreen(32, 32);
                var whole = Renderer.load(
                        offscreen.gl, square(), TestAssets.NONE, settings(Output.PLAIN, 1, Upscale.BILINEAR));
                var scaled = Renderer.load(
                        offscreen.gl, square(), TestAssets.NONE, settings(Output.PLAIN, 0.5, Upscale.BILINEAR))) {
            assertFalse(whole.stepNames().contains("upscale"));
            assertTrue(scaled.stepNames().contains("upscale"));
        }
    }

    /** Both outputs give the same picture up to dither, at every size of the window, also of a single pixel. */
    @ParameterizedTest
    @CsvSource({"96, 96, 0.5", "33, 17, 0.5", "1, 1, 0.25", "5, 1, 0.3", "64, 48, 0.7"})
    void outputsAgreeAtEverySize(int width, int height, double resolution) {
        try (var offscreen = new Offscreen(width, height)) {
            int[] direct = offscreen.pixels(
                    square(), TestAssets.NONE, AHEAD, settings(Output.DIRECT, resolution, Upscale.BILINEAR));
            int[] hdr = offscreen.pixels(
                    square(), TestAssets.NONE, AHEAD, settings(Output.HDR, resolution, Upscale.BILINEAR));
            for (int i = 0; i < direct.length; i++) {
                assertEquals(Offscreen.red(direct[i]), Offscreen.red(hdr[i]), 2);
            }
        }
    }

    /** The radiance has the pixels that were drawn. */
    @Test
    void radianceIsThatOfTheDrawnPixels() {
        try (var offscreen = new Offscreen(64, 32);
                var renderer = Renderer.load(
                        offscreen.gl, square(), TestAssets.NONE, settings(Output.HDR, 0.5, Upscale.BILINEAR))) {
            renderer.draw(AHEAD, offscreen.picture);
            assertEquals(3 * 32 * 16, renderer.readRadiance().length);
        }
    }

    @Test
    void aRendererDrawsTheSamePictureAgain() {
        try (var offscreen = new Offscreen(64, 64);
                var renderer = Renderer.load(
                        offscreen.gl, square(), TestAssets.NONE, settings(Output.DIRECT, 0.6, Upscale.CATMULL_ROM))) {
            renderer.draw(AHEAD, offscreen.picture);
            int[] first = offscreen.pixels();
            renderer.draw(AHEAD, offscreen.picture);
            assertArrayEquals(first, offscreen.pixels());
        }
    }
}
