package nephele.engine.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import nephele.engine.level.Level;
import nephele.engine.level.Sky;
import nephele.engine.level.TestLevel;
import nephele.engine.level.ToneCurve;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.ToneMapping;
import nephele.engine.scene.View;
import org.junit.jupiter.api.Test;

/** Tone curve, sRGB and dither are applied once, equally in both outputs, and as by their Java twin. */
class OutputGlTest {
    private static Level landscape(ToneCurve curve, double stops) {
        return new TestLevel()
                .toneMapping(curve, stops)
                .sun(new Vec3(0.4, 1, 0.2), 3)
                .ambient(0.15)
                .sky(new Sky.Gradient(new Vec3(0.05, 0.2, 0.9), new Vec3(0.8, 0.9, 1.4), TestLevel.grey(0.02)))
                .material("red", new Vec3(0.9, 0.2, 0.01))
                .box("red", new Vec3(0, 0, -4), new Vec3(2, 2, 2))
                .box(null, new Vec3(0, -1.5, 0), new Vec3(30, 1, 30))
                .level();
    }

    @Test
    void directAndHdrAgreeWithinOneCode() {
        try (Offscreen offscreen = new Offscreen(96, 96)) {
            View view = offscreen.view(new Vec3(1, 1, 1), new Vec3(0, 0.5, -4));
            for (ToneCurve curve : ToneCurve.values()) {
                for (double stops : new double[] {-3, 0, 1.5}) {
                    Level level = landscape(curve, stops);
                    int[] direct = offscreen.pixels(level, view, Output.DIRECT);
                    int[] hdr = offscreen.pixels(level, view, Output.HDR);
                    assertEquals(0, countApart(direct, hdr, 1), curve + " at " + stops + " stops");
                    assertTrue(Arrays.stream(direct).distinct().count() > 10);
                }
            }
        }
    }

    private static long countApart(int[] a, int[] b, int codes) {
        long apart = 0;
        for (int i = 0; i < a.length; i++) {
            boolean near = Math.abs(Offscreen.red(a[i]) - Offscreen.red(b[i])) <= codes
                    && Math.abs(Offscreen.green(a[i]) - Offscreen.green(b[i])) <= codes
                    && Math.abs(Offscreen.blue(a[i]) - Offscreen.blue(b[i])) <= codes;
            apart += near ? 0 : 1;
        }
        return apart;
    }

    /** The mean of the dithered codes is the twin's value; every single code is within one of it. */
    @Test
    void toneMappingEqualsItsJavaTwin() {
        try (Offscreen offscreen = new Offscreen(64, 64)) {
            View view = offscreen.view(new Vec3(0, 2, 0), Vec3.ZERO);
            for (ToneCurve curve : ToneCurve.values()) {
                for (double radiance :
                        new double[] {0, 1e-4, 0.002, 0.0031308, 0.004, 0.01, 0.03, 0.2140, 0.5, 0.97, 1, 3, 60000}) {
                    Level level = new TestLevel()
                            .toneMapping(curve, -0.5)
                            .ambient(1)
                            .material("m", TestLevel.grey(radiance))
                            .box("m", new Vec3(0, -0.5, 0), new Vec3(40, 1, 40))
                            .level();
                    double code = 255 * ToneMapping.displayValue(radiance, Math.pow(2, -0.5), curve);
                    int[] pixels = offscreen.pixels(level, view, Output.DIRECT);
                    double mean = Arrays.stream(pixels)
                            .map(Offscreen::green)
                            .average()
                            .orElse(-1);
                    assertEquals(code, mean, 0.06, curve + " of " + radiance);
                    assertTrue(Arrays.stream(pixels).allMatch(p -> Math.abs(Offscreen.green(p) - code) < 1.05));
                }
            }
        }
    }

    /** Mid grey 0.2140 is display code 127.5. */
    @Test
    void middleGreyIsTheMiddleCode() {
        assertEquals(127.5, 255 * ToneMapping.encodeSrgb(0.2140), 0.05);
        assertEquals(0.2140, ToneMapping.decodeSrgb(127.5 / 255), 1e-4);
        for (double x = 0; x <= 1; x += 0x1p-8) {
            assertEquals(x, ToneMapping.decodeSrgb(ToneMapping.encodeSrgb(x)), 1e-6);
        }
    }

    /** A constant sky as clear colour equals a uniform gradient, except for the dither. */
    @Test
    void aConstantSkyIsDevelopedOnTheCpu() {
        Vec3 radiance = new Vec3(0.7, 0.3, 0.05);
        Level constant = new TestLevel().sky(new Sky.Constant(radiance)).level();
        Level gradient = new TestLevel()
                .sky(new Sky.Gradient(radiance, radiance, radiance))
                .level();
        try (Offscreen offscreen = new Offscreen(32, 32)) {
            View view = offscreen.view(Vec3.ZERO, new Vec3(0, 0, -1));
            for (Output output : Output.values()) {
                int[] cleared = offscreen.pixels(constant, view, output);
                int[] drawn = offscreen.pixels(gradient, view, output);
                assertEquals(0, countApart(cleared, drawn, 1), output.toString());
            }
            int[] hdr = offscreen.pixels(constant, view, Output.HDR);
            int[] direct = offscreen.pixels(constant, view, Output.DIRECT);
            assertEquals(0, countApart(hdr, direct, 1));
            assertEquals(1, Arrays.stream(direct).distinct().count());
        }
    }

    @Test
    void plainShowsValuesAsStored() {
        try (Offscreen offscreen = new Offscreen(8, 8)) {
            Level level = new TestLevel()
                    .toneMapping(ToneCurve.FILMIC, 2)
                    .sun(new Vec3(0, 1, 0), 0.8 * Math.PI)
                    .ambient(0.3)
                    .material("m", new Vec3(0.5, 0.25, 1))
                    .box("m", new Vec3(0, -0.5, 0), new Vec3(40, 1, 40))
                    .level();
            int[] pixels = offscreen.pixels(level, offscreen.view(new Vec3(0, 2, 0), Vec3.ZERO), Output.PLAIN);
            int expected = (int) Math.round(255 * 0.55) << 16 | (int) Math.round(255 * 0.275) << 8 | 255;
            assertTrue(Arrays.stream(pixels).allMatch(p -> p == expected));
        }
    }
}
