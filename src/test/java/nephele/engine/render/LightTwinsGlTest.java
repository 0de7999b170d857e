package nephele.engine.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import nephele.engine.level.appearance.Brdf;
import nephele.engine.level.appearance.FaceTexture;
import nephele.engine.level.appearance.PunctualLight;
import nephele.engine.math.Vec3;
import nephele.engine.scene.light.PackedLight;
import nephele.engine.scene.light.ShadowFilter;
import nephele.engine.scene.light.SkyIrradiance;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Every include that computes light equals its Java twin: float on one side, double on the other. */
class LightTwinsGlTest {
    private static final int COUNT = 4096;

    /**
     * At the lobe's peak, which squares a difference of nearly equal floats, the error is 2 % below roughness 0.2 and
     * 0.2 % above.
     */
    @Test
    void brdf() {
        SplittableRandom random = new SplittableRandom(1);
        float[] in = new float[16 * COUNT];
        for (int i = 0; i < COUNT; i++) {
            float[] n = unit(random);
            fill(in, 16 * i, random.nextDouble(), random.nextDouble(), random.nextDouble(), random.nextDouble());
            fill(in, 16 * i + 4, n[0], n[1], n[2], i % 3 == 0 ? 0 : i % 3 == 1 ? 1 : random.nextDouble());
            float[] v = towards(n, unit(random));
            fill(in, 16 * i + 8, v[0], v[1], v[2], 0);
            float[] l = i % 7 == 0 ? mirrored(v, n) : unit(random);
            fill(in, 16 * i + 12, l[0], l[1], l[2], 0);
        }
        float[] gpu = TwinProgram.run("brdf.frag", in, COUNT, uniforms -> {});
        for (int i = 0; i < COUNT; i++) {
            Vector3d n = vector(in, 16 * i + 4);
            Vector3d v = vector(in, 16 * i + 8);
            Vector3d expected = Brdf.of(vector(in, 16 * i), in[16 * i + 3], in[16 * i + 7], n.dot(v))
                    .reflected(n, v, vector(in, 16 * i + 12));
            double roughness = Math.max(in[16 * i + 3], Brdf.MIN_ROUGHNESS);
            assertClose(expected, gpu, i, roughness < 0.2 ? 2e-2 : 2e-3, 1e-5);
        }
    }

    /** ALL_DIFFUSE adds diffuse light in place of an insulator's specular lobe: the lobe's albedo at middle roughness. */
    @ParameterizedTest
    @CsvSource({"0.1, 0.09", "0.6, 0.05", "1, 0.02"})
    void anInsulatorsLobeReturnsFivePercent(double roughness, double albedo) {
        double sum = 0;
        for (int i = 0; i < 1000; i++) {
            // Equal steps of the cosine's square are equal parts of the cosine-weighted hemisphere.
            double mu = Math.sqrt((i + 0.5) / 1000);
            sum += Brdf.of(new Vector3d(), roughness, 0, mu).ambientSpecular().x() / 1000;
        }
        assertEquals(albedo, sum, 0.005);
    }

    /** White metal and a white insulator of every roughness reflect 1 in a white furnace, on the GPU too. */
    @Test
    void ambientReflectanceOfWhiteIsOne() {
        float[] in = new float[8 * COUNT];
        SplittableRandom random = new SplittableRandom(2);
        for (int i = 0; i < COUNT; i++) {
            fill(in, 8 * i, 1, 1, 1, random.nextDouble() * 1.4 - 0.2);
            fill(in, 8 * i + 4, i % 2, random.nextDouble() * 2 - 1, 0, 0);
        }
        float[] gpu = TwinProgram.run("ambient-reflectance.frag", in, COUNT, uniforms -> {});
        for (float reflected : gpu) {
            assertEquals(1, reflected, 2e-6);
        }
    }

    /** For any distance, range and cone the relative error is 1e-5, since the window squares a difference. */
    @Test
    void lightFalloff() {
        SplittableRandom random = new SplittableRandom(3);
        double[] odd = {0, 1e-30, 1e-8, 1e-4, 1, 1e18, 1e30};
        float[] in = new float[8 * COUNT];
        for (int i = 0; i < COUNT; i++) {
            double d2 = i % 4 == 0 ? odd[random.nextInt(odd.length)] : random.nextDouble() * 100;
            double range = i % 9 == 0 ? 1e9 : 0.001 + random.nextDouble() * 12;
            fill(in, 8 * i, d2, 1 / (range * range), 0, 0);
            fill(in, 8 * i + 4, random.nextDouble() * 2 - 1, random.nextDouble() * 100, -random.nextDouble() * 50, 0);
        }
        float[] gpu = TwinProgram.run("light-falloff.frag", in, COUNT, uniforms -> {});
        for (int i = 0; i < COUNT; i++) {
            Vector3d expected = new Vector3d(
                    PunctualLight.windowedInverseSquare(in[8 * i], in[8 * i + 1]),
                    PunctualLight.cone(in[8 * i + 4], in[8 * i + 5], in[8 * i + 6]),
                    0);
            assertClose(expected, gpu, i, 1e-3, 1e-5);
        }
    }

    /** Depths are in steps away from all tolerances, so that no comparison depends on a float's rounding. */
    @Test
    void shadowFilter() {
        SplittableRandom random = new SplittableRandom(4);
        float[] in = new float[16 * COUNT];
        for (int i = 0; i < COUNT; i++) {
            double x = random.nextInt(64) + 0.25 * random.nextInt(4) + 0.125;
            double y = random.nextInt(64) + 0.25 * random.nextInt(4) + 0.125;
            fill(in, 16 * i, x, y, (random.nextInt(9) - 4) / 64.0, (random.nextInt(9) - 4) / 64.0);
            float[] n = unit(random);
            double depth = random.nextInt(1, 40) / 32.0;
            fill(in, 16 * i + 4, n[0], n[1], n[2], depth);
            for (int texel = 0; texel < 4; texel++) {
                int octant = random.nextBoolean() ? octant(n) : random.nextInt(8);
                double near = Math.min(depth, 1) + odd(random) / 2048.0;
                float stored = (float) (random.nextInt(3) == 0 ? random.nextDouble() : near);
                in[16 * i + 8 + texel] = i % 5 == 0 && texel == 3 ? 1 : ShadowFilter.depthWithOctant(stored, octant);
            }
            fill(in, 16 * i + 12, 1 / 128.0, 1 + random.nextInt(30), 0, 0);
        }
        float[] gpu = TwinProgram.run("shadow-filter.frag", in, COUNT, uniforms -> {});
        for (int i = 0; i < COUNT; i++) {
            assertClose(shadowFilterTwin(in, 16 * i), gpu, i, 1e-5, 1e-5);
        }
    }

    private static int odd(SplittableRandom random) {
        return 2 * random.nextInt(-20, 20) + 1;
    }

    private static int octant(float[] n) {
        return ShadowFilter.octantOf(new Vec3(n[0], n[1], n[2]));
    }

    private static Vector3d shadowFilterTwin(float[] in, int at) {
        var four = ShadowFilter.Footprint.at(in[at], in[at + 1]);
        double gx = in[at + 2];
        double gy = in[at + 3];
        int octant = octant(new float[] {in[at + 4], in[at + 5], in[at + 6]});
        double[] depths = new double[4];
        boolean[] isLike = new boolean[4];
        for (int i = 0; i < 4; i++) {
            depths[i] = in[at + 8 + i];
            isLike[i] = ShadowFilter.looksLike(in[at + 8 + i], octant);
        }
        double half = in[at + 12];
        double range = in[at + 13];
        double slope = Math.abs(gx) + Math.abs(gy);
        double[] nearerBy = ShadowFilter.nearerThanPlane(depths, in[at + 7], gx, gy, four);
        double[] ofLight = ShadowFilter.nearerThanPlaneOfLight(depths, in[at + 7] * range, gx, gy, range, four);
        return new Vector3d(
                ShadowFilter.litShare(nearerBy, four.weight(), half, slope),
                ShadowFilter.litShareOfMapped(nearerBy, isLike, four.weight(), half, slope),
                ofLight[0]
                        + 2 * ofLight[1]
                        + 3 * ofLight[2]
                        + 4 * ofLight[3]
                        + (ShadowFilter.litByNearest(nearerBy[0], half, slope) ? 100 : 0)
                        + (ShadowFilter.litByNearestOfMapped(nearerBy[0], isLike[0], half, slope) ? 200 : 0));
    }

    /** Mapped normals equal the twin's, for degenerate texels and opposite vectors too. */
    @Test
    void normalMap() {
        SplittableRandom random = new SplittableRandom(5);
        float[] in = new float[16 * COUNT];
        for (int i = 0; i < COUNT; i++) {
            boolean black = i % 10 == 0;
            fill(in, 16 * i, black ? 0 : random.nextDouble(), black ? 0 : random.nextDouble(), random.nextDouble(), 0);
            for (int v = 1; v <= 3; v++) {
                float[] u = unit(random);
                fill(in, 16 * i + 4 * v, u[0], u[1], u[2], 0);
            }
        }
        float[] gpu = TwinProgram.run("normal-map.frag", in, COUNT, uniforms -> {});
        for (int i = 0; i < COUNT; i++) {
            Vector3d expected = FaceTexture.mappedNormal(
                    vector(in, 16 * i), vector(in, 16 * i + 4), vector(in, 16 * i + 8), vector(in, 16 * i + 12));
            assertClose(expected, gpu, i, 1e-3, 1e-4);
        }
    }

    @Test
    void skyAmbient() {
        SkyIrradiance sky =
                SkyIrradiance.of((height, x, y, z) -> new Vector3d(1 + x, Math.max(y, 0), 0.5 + 0.5 * z * z));
        SplittableRandom random = new SplittableRandom(6);
        float[] in = new float[4 * COUNT];
        for (int i = 0; i < COUNT; i++) {
            float[] n = unit(random);
            fill(in, 4 * i, n[0], n[1], n[2], 0);
        }
        float[] gpu = TwinProgram.run("sky-ambient.frag", in, COUNT, uniforms -> {
            double[] c = sky.coefficients();
            for (int i = 0; i < SkyIrradiance.TERMS; i++) {
                uniforms.vector3("skyCoefficients[" + i + "]")
                        .set((float) c[3 * i], (float) c[3 * i + 1], (float) c[3 * i + 2]);
            }
        });
        for (int i = 0; i < COUNT; i++) {
            Vector3d n = vector(in, 4 * i);
            assertClose(sky.ambient(n.x, n.y, n.z), gpu, i, 1e-5, 1e-6);
        }
    }

    /** Directions of every length, with normals towards, away from and across them. */
    @Test
    void relativeIrradiance() {
        SplittableRandom random = new SplittableRandom(7);
        float[] in = new float[8 * COUNT];
        for (int i = 0; i < COUNT; i++) {
            float[] d = unit(random);
            float[] n = i % 5 == 0 ? d : i % 5 == 1 ? new float[] {-d[0], -d[1], -d[2]} : unit(random);
            double length = i % 7 == 0 ? 0 : i % 7 == 1 ? 1 : random.nextDouble();
            fill(in, 8 * i, length * d[0], length * d[1], length * d[2], 0);
            fill(in, 8 * i + 4, n[0], n[1], n[2], 0);
        }
        float[] gpu = TwinProgram.run("baked-light.frag", in, COUNT, uniforms -> {});
        for (int i = 0; i < COUNT; i++) {
            Vec3 d = Vec3.of(vector(in, 8 * i));
            double expected = PackedLight.relativeIrradiance(d, Vec3.of(vector(in, 8 * i + 4)));
            assertClose(new Vector3d(expected, d.length(), 0), gpu, i, 1e-4, 1e-5);
        }
    }

    private static void assertClose(Vector3d expected, float[] gpu, int i, double relative, double absolute) {
        for (int c = 0; c < 3; c++) {
            double e = expected.get(c);
            float g = gpu[3 * i + c];
            assertTrue(
                    Math.abs(g - e) <= absolute + relative * Math.abs(e),
                    "input " + i + ", component " + c + ": GPU " + g + ", twin " + e);
        }
    }

    private static void fill(float[] in, int at, double x, double y, double z, double w) {
        in[at] = (float) x;
        in[at + 1] = (float) y;
        in[at + 2] = (float) z;
        in[at + 3] = (float) w;
    }

    private static Vector3d vector(float[] in, int at) {
        return new Vector3d(in[at], in[at + 1], in[at + 2]);
    }

    private static float[] unit(SplittableRandom random) {
        double z = 2 * random.nextDouble() - 1;
        double angle = 2 * Math.PI * random.nextDouble();
        double r = Math.sqrt(1 - z * z);
        return new float[] {(float) (r * Math.cos(angle)), (float) (r * Math.sin(angle)), (float) z};
    }

    /** Returns v on the normal's side. */
    private static float[] towards(float[] n, float[] v) {
        float d = n[0] * v[0] + n[1] * v[1] + n[2] * v[2];
        return d >= 0 ? v : new float[] {-v[0], -v[1], -v[2]};
    }

    private static float[] mirrored(float[] v, float[] n) {
        float d = 2 * (n[0] * v[0] + n[1] * v[1] + n[2] * v[2]);
        return new float[] {d * n[0] - v[0], d * n[1] - v[1], d * n[2] - v[2]};
    }
}
