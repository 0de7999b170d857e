package nephele.engine.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Level;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Quality;
import nephele.engine.render.frame.Quality.Antialiasing;
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
                output,
                Quality.HIGH.inOneFrame().with("pictureResolution", resolution).with("upscale", filter));
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
     * A small picture of slanted squares, drawn for itself and scaled in double precision, equals the scaled one within
     * rounding: a texture unit's weights have 8 bits.
     */
    @ParameterizedTest
    @EnumSource(Upscale.class)
    void filtersEqualTheirTwins(Upscale filter) {
        Level squares = new TestLevel()
                .ambient(1)
                .material("white", TestLevel.grey(1))
                .material("grey", TestLevel.grey(0.3))
                .material("dark", TestLevel.grey(0.1))
                .box("white", new Vec3(0, 0, -0.5), new Vec3(2, 2, 1))
                .box("grey", new Vec3(0.6, 0.5, 0), new Vec3(0.9, 0.07, 0.2))
                .box("dark", new Vec3(-0.3, -0.2, 0), new Vec3(0.8, 0.8, 0.2))
                .level();
        View slanted = View.lookAt(
                new Vec3(0.2, 0.1, 1.5), Vec3.ZERO, new Vec3(0.3, 1, 0), new Projection(Math.PI / 2, 1, 0.05, 1000));
        double[] small;
        try (var offscreen = new Offscreen(32, 32)) {
            int[] pixels = offscreen.pixels(squares, TestAssets.NONE, slanted, settings(Output.PLAIN, 1, filter));
            small = Arrays.stream(pixels)
                    .mapToDouble(pixel -> Offscreen.red(pixel) / 255.0)
                    .toArray();
        }
        var twin = new UpscaleTwin(small, 32);
        try (var offscreen = new Offscreen(80, 80)) {
            int[] scaled = offscreen.pixels(squares, TestAssets.NONE, slanted, settings(Output.PLAIN, 0.4, filter));
            for (int i = 0; i < scaled.length; i++) {
                double exact = 255 * twin.at((i % 80 + 0.5) * 0.4 - 0.5, (i / 80 + 0.5) * 0.4 - 0.5, filter);
                assertEquals(exact, Offscreen.red(scaled[i]), 1.5, "pixel " + i % 80 + ", " + i / 80);
            }
        }
    }

    /** Beside an edge between two flat areas, slanted or not, no filter leaves the range of their values. */
    @ParameterizedTest
    @EnumSource(Upscale.class)
    void flatAreasHaveNoHalo(Upscale filter) {
        for (int degrees = 0; degrees < 180; degrees += 15) {
            double[] small = new double[24 * 24];
            for (int i = 0; i < small.length; i++) {
                double side = (i % 24 - 11.3) * Math.cos(Math.toRadians(degrees))
                        + (i / 24 - 11.8) * Math.sin(Math.toRadians(degrees));
                small[i] = side < 0 ? 60 / 255.0 : 190 / 255.0;
            }
            var twin = new UpscaleTwin(small, 24);
            for (int i = 0; i < 48 * 48; i++) {
                double code = 255 * twin.at((i % 48 + 0.5) / 2 - 0.5, (i / 48 + 0.5) / 2 - 0.5, filter);
                assertEquals(125, code, 65 + 1e-9, degrees + "°, pixel " + i % 48 + ", " + i / 48);
            }
        }
    }

    /** A level whose picture is one colour is drawn by a clear alone; nothing is scaled or filtered. */
    @Test
    void theEmptyLevelIsOneClearAtEveryQuality() {
        var settings = RenderSettings.of(Output.PLAIN, Quality.LOW.with("antialiasing", Antialiasing.MORPHOLOGICAL));
        try (var offscreen = new Offscreen(8, 8);
                var renderer = LevelRenderer.load(offscreen.gl, new TestLevel().level(), TestAssets.NONE, settings)) {
            assertEquals(List.of("clear"), renderer.stepNames());
        }
    }

    @Test
    void resolutionOneHasNoStepMore() {
        try (var offscreen = new Offscreen(32, 32);
                var whole = LevelRenderer.load(
                        offscreen.gl, square(), TestAssets.NONE, settings(Output.PLAIN, 1, Upscale.BILINEAR));
                var scaled = LevelRenderer.load(
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
                var renderer = LevelRenderer.load(
                        offscreen.gl, square(), TestAssets.NONE, settings(Output.HDR, 0.5, Upscale.BILINEAR))) {
            renderer.draw(AHEAD, offscreen.picture);
            assertEquals(3 * 32 * 16, renderer.readRadiance().length);
        }
    }

    @Test
    void aRendererDrawsTheSamePictureAgain() {
        try (var offscreen = new Offscreen(64, 64);
                var renderer = LevelRenderer.load(
                        offscreen.gl, square(), TestAssets.NONE, settings(Output.DIRECT, 0.6, Upscale.EDGE_ADAPTIVE))) {
            renderer.draw(AHEAD, offscreen.picture);
            int[] first = offscreen.pixels();
            renderer.draw(AHEAD, offscreen.picture);
            assertArrayEquals(first, offscreen.pixels());
        }
    }
}
