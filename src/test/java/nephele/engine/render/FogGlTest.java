package nephele.engine.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import nephele.engine.level.Environment;
import nephele.engine.level.Level;
import nephele.engine.level.Material;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.appearance.FogTransmittance;
import nephele.engine.level.placed.NoFiles;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Vec3;
import nephele.engine.reference.ReferencePicture;
import nephele.engine.reference.TraceSettings;
import nephele.engine.reference.TracedLevel;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.Output;
import nephele.engine.scene.View;
import nephele.lab.bake.TracedPictures;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** Fog is mix(fog, c, exp(−k d)), on the GPU as in its Java twin, and on surfaces at any distance. */
class FogGlTest {
    private static final int COUNT = 1024;
    private static final int SIZE = 32;
    private static final Vec3 FOG = new Vec3(0.3, 0.6, 0.9);
    private static final Vec3 COLOUR = new Vec3(0.8, 0.1, 0.4);

    /** Places up to 1 km around eyes up to 20 scale heights above and below the base, whose scale is 1 m to 10 km. */
    @Test
    void theShaderIsTheJavaTwin() {
        SplittableRandom random = new SplittableRandom(5);
        float[] in = new float[8 * COUNT];
        for (int i = 0; i < COUNT; i++) {
            double metres = Math.pow(10, 3 - i % 6);
            in[8 * i] = (float) (metres * random.nextDouble(-1, 1));
            in[8 * i + 1] = (float) (i % 7 == 0 ? 0 : metres * random.nextDouble(-1, 1));
            in[8 * i + 2] = (float) Math.pow(10, -(i % 5));
            in[8 * i + 3] = (float) random.nextDouble(-20, 20);
            in[8 * i + 4] = (float) Math.pow(10, -(i % 4.1));
        }
        float[] gpu = TwinProgram.run("fog.frag", in, COUNT, uniforms -> {});
        for (int i = 0; i < COUNT; i++) {
            double scale = 1 / (double) in[8 * i + 4];
            var fog = new FogTransmittance(in[8 * i + 2], FOG, 0, scale);
            double metres = Math.hypot(in[8 * i], in[8 * i + 1]);
            double rise = in[8 * i + 1] / metres;
            double eye = in[8 * i + 3] * scale;
            assertEquals(fog.transmittance(eye, rise, metres), gpu[3 * i], 2e-5, "place " + i);
            assertEquals(
                    fog.transmittance(eye, rise, Double.POSITIVE_INFINITY), gpu[3 * i + 1], 2e-5, "direction " + i);
            assertEquals(gpu[3 * i], gpu[3 * i + 2], 1e-6);
        }
    }

    /** The optical depth of fog that thins with altitude is the sum of that of its parts, at any angle and scale. */
    @ParameterizedTest
    @CsvSource({"1e-6", "1", "20", "1e7"})
    void theDepthIsTheIntegralOfTheExtinction(double scaleMetres) {
        var fog = new FogTransmittance(1e-3, FOG, 2, scaleMetres);
        SplittableRandom random = new SplittableRandom(3);
        for (int ray = 0; ray < 50; ray++) {
            double eye = random.nextDouble(-30, 30);
            double rise = ray % 5 == 0 ? 0 : random.nextDouble(-1, 1);
            double metres = random.nextDouble(1, 300);
            int parts = 20_000;
            double depth = 0;
            for (int part = 0; part < parts; part++) {
                double altitude = eye + rise * metres * (part + 0.5) / parts;
                depth += 1e-3 * metres / parts * Math.exp(-Math.max(0, altitude - 2) / scaleMetres);
            }
            assertEquals(Math.exp(-depth), fog.transmittance(eye, rise, metres), 1e-5, eye + " " + rise);
        }
    }

    /** Seen upwards, sky remains; a ray of 10^9 m has the depth of one without end. */
    @Test
    void fogThatEndsLeavesTheSky() {
        var fog = new FogTransmittance(0.02, FOG, 0, 25);
        assertEquals(Math.exp(-0.02 * 25 / 0.5), fog.transmittance(0, 0.5, Double.POSITIVE_INFINITY), 1e-12);
        assertEquals(Math.exp(-0.02 * 35), fog.transmittance(-10, 1, Double.POSITIVE_INFINITY), 1e-12);
        assertEquals(0, fog.transmittance(10, 0, Double.POSITIVE_INFINITY));
        assertEquals(fog.transmittance(3, 0.1, Double.POSITIVE_INFINITY), fog.transmittance(3, 0.1, 1e9), 1e-12);
    }

    static Stream<Sky> skies() {
        return Stream.of(
                null,
                new Sky.Constant(TestLevel.grey(0.7)),
                new Sky.Gradient(TestLevel.grey(1), TestLevel.grey(0.4), TestLevel.grey(0.1)),
                Sky.Atmosphere.CLEAR);
    }

    /** Walls, ground, what is behind a portal in a floor and each kind of sky through fog that ends, drawn as traced. */
    @ParameterizedTest
    @MethodSource("skies")
    void fogThatEndsIsDrawnAsTraced(Sky sky) {
        Level level = new TestLevel()
                .sky(sky)
                .sun(new Vec3(0.3, 0.5, -1), 3)
                .ambient(0)
                .fog(new Environment.Fog(0.05, FOG, 1, 3))
                .material(new Material("glow", new Vec3(0, 0, 0), null, null, null, null, COLOUR, 1))
                .box("glow", new Vec3(0, -0.5, -10), new Vec3(60, 1, 40))
                .box("glow", new Vec3(-4, 4, -14), new Vec3(2, 12, 2))
                .box("glow", new Vec3(3, 1.5, -7.5), new Vec3(4, 3, 1))
                .box("glow", new Vec3(3, 40, -200.5), new Vec3(4, 4, 1))
                .portal("a", "b", new Vec3(3, 1.5, -7), new Vec3(0, 0, 1), 1.4, 2)
                .portal("b", "a", new Vec3(3, 40, -200), new Vec3(0, 0, 1), 1.4, 2)
                .level();
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            View view = offscreen.view(new Vec3(0, 1.7, 0), new Vec3(0.3, 2.2, -1.5));
            float[] drawn = offscreen.radiance(level, NoFiles.AT_ALL, view);
            var twin = TracedLevel.of(PlacedLevel.of(level, NoFiles.AT_ALL), ColourDecoding.SRGB);
            float[] traced = ReferencePicture.trace(
                    twin, TracedPictures.pinhole(view), new TraceSettings(SIZE, SIZE, 1, 1, 2), done -> {});
            int differing = 0;
            for (int i = 0; i < drawn.length; i++) {
                differing += Math.abs(drawn[i] - traced[i]) > 0.004 + 0.004 * traced[i] ? 1 : 0;
            }
            assertTrue(differing < 0.03 * drawn.length, differing + " of " + drawn.length + " values differ");
        }
    }

    /**
     * A luminous wall 2 m away under fog of very small, 1 and 100 optical depths is exact within 1/255, Lambertian and
     * glossy.
     */
    @Test
    void aWallFadesByItsDistance() {
        try (Offscreen offscreen = new Offscreen(SIZE, SIZE)) {
            View view = offscreen.view(Vec3.ZERO, new Vec3(0, 0, -1));
            for (Double roughness : new Double[] {null, 0.9}) {
                for (double thickness : new double[] {1e-9, 1, 100}) {
                    int[] pixels = offscreen.pixels(wall(roughness, thickness / 2), view, Output.PLAIN);
                    for (int i = 0; i < pixels.length; i++) {
                        double x = (2 * (i % SIZE) + 1.0) / SIZE - 1;
                        double y = (2 * (i / SIZE) + 1.0) / SIZE - 1;
                        double metres = 2 * Math.sqrt(1 + x * x + y * y);
                        double left = Math.exp(-thickness / 2 * metres);
                        assertEquals(255 * mix(FOG.x(), COLOUR.x(), left), Offscreen.red(pixels[i]), 1);
                        assertEquals(255 * mix(FOG.y(), COLOUR.y(), left), Offscreen.green(pixels[i]), 1);
                        assertEquals(255 * mix(FOG.z(), COLOUR.z(), left), Offscreen.blue(pixels[i]), 1);
                    }
                }
            }
        }
    }

    private static double mix(double fog, double colour, double left) {
        return fog + (colour - fog) * left;
    }

    private static Level wall(Double roughness, double extinctionPerMetre) {
        return new TestLevel()
                .fog(extinctionPerMetre, FOG)
                .material(new Material("glow", new Vec3(0, 0, 0), null, roughness, null, null, COLOUR, 1))
                .box("glow", new Vec3(0, 0, -3), new Vec3(20, 20, 2))
                .level();
    }

    /** The clear colour replaces every sky in fog, and no sky pass is required. */
    @Test
    void theSkyIsTheFogs() {
        Sky sky = new Sky.Gradient(TestLevel.grey(1), TestLevel.grey(0.2), TestLevel.grey(0));
        Level foggy = new TestLevel().sky(sky).fog(1e-6, FOG).level();
        Level clear = new TestLevel().sky(sky).fog(0, FOG).level();
        assertEquals(
                List.of(),
                FramePlan.of(FrameRequest.of(PlacedLevel.of(foggy, NoFiles.AT_ALL), Output.PLAIN))
                        .required());
        assertEquals(
                1,
                FramePlan.of(FrameRequest.of(PlacedLevel.of(clear, NoFiles.AT_ALL), Output.PLAIN))
                        .required()
                        .size());
        try (Offscreen offscreen = new Offscreen(4, 4)) {
            View view = offscreen.view(Vec3.ZERO, new Vec3(0, 0, -1));
            for (int pixel : offscreen.pixels(foggy, view, Output.PLAIN)) {
                assertEquals(Math.rint(255 * FOG.y()), Offscreen.green(pixel), 1);
            }
            assertTrue(Offscreen.green(offscreen.pixels(clear, view, Output.PLAIN)[0]) < 100);
        }
    }
}
