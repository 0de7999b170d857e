package nephele.engine.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.level.Level;
import nephele.engine.level.Material;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.level.appearance.FogTransmittance;
import nephele.engine.level.placed.NoFiles;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.FrameRequest;
import nephele.engine.render.frame.Output;
import nephele.engine.scene.View;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;

/** Fog is mix(fog, c, exp(−k d)), on the GPU as in its Java twin, and on surfaces at any distance. */
class FogGlTest {
    private static final int COUNT = 1024;
    private static final int SIZE = 32;
    private static final Vec3 FOG = new Vec3(0.3, 0.6, 0.9);
    private static final Vec3 COLOUR = new Vec3(0.8, 0.1, 0.4);

    @Test
    void theShaderIsTheJavaTwin() {
        SplittableRandom random = new SplittableRandom(5);
        float[] in = new float[8 * COUNT];
        for (int i = 0; i < in.length; i++) {
            in[i] = (float) (random.nextDouble() * (i % 8 == 3 ? 1000 : i % 8 == 7 ? Math.pow(10, -i % 5) : 4));
        }
        float[] gpu = TwinProgram.run("fog.frag", in, COUNT, uniforms -> {});
        for (int i = 0; i < COUNT; i++) {
            int at = 8 * i;
            Vec3 fog = new Vec3(in[at + 4], in[at + 5], in[at + 6]);
            Vector3d behind = new Vector3d(in[at], in[at + 1], in[at + 2]);
            Vector3d expected = new FogTransmittance(in[at + 7], fog).over(behind, in[at + 3]);
            for (int channel = 0; channel < 3; channel++) {
                assertEquals(expected.get(channel), gpu[3 * i + channel], 1e-5, "pixel " + i);
            }
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
