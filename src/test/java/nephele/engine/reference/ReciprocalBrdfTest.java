package nephele.engine.reference;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import java.util.SplittableRandom;
import nephele.engine.level.appearance.Brdf;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;
import org.joml.Vector3dc;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The reflection of the reference is reciprocal, loses and gains no energy, and is sampled as its density says. */
class ReciprocalBrdfTest {
    private static final Vector3dc NORMAL = new Vector3d(0, 1, 0);
    private static final int SAMPLES = 40_000;

    private static SurfacePoint surface(Vector3dc colour, double roughness, double metallic, Vector3dc toEye) {
        Brdf drawn = Brdf.of(colour, roughness, metallic, NORMAL.dot(toEye));
        return new SurfacePoint(0, Vec3.ZERO, NORMAL, NORMAL, NORMAL, colour, drawn, toEye, Vec3.ZERO, false)
                .reciprocal();
    }

    private static Vector3d direction(double cosine, double angle) {
        double sine = Math.sqrt(1 - cosine * cosine);
        return new Vector3d(sine * Math.cos(angle), cosine, sine * Math.sin(angle));
    }

    @Test
    void eyeAndLightMayBeExchanged() {
        Random random = new Random(1);
        for (int i = 0; i < 2000; i++) {
            Vector3d colour = new Vector3d(random.nextDouble(), random.nextDouble(), random.nextDouble());
            double roughness = random.nextDouble();
            double metallic = random.nextInt(3) / 2.0;
            Vector3d a = direction(0.002 + 0.998 * random.nextDouble(), 6.3 * random.nextDouble());
            Vector3d b = direction(0.002 + 0.998 * random.nextDouble(), 6.3 * random.nextDouble());
            Vector3d forth =
                    surface(colour, roughness, metallic, a).reflected(b).div(b.y);
            Vector3d back = surface(colour, roughness, metallic, b).reflected(a).div(a.y);
            assertEquals(0, forth.distance(back) / forth.length(), 1e-9, a + " and " + b + ", roughness " + roughness);
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 0.05, 0.1, 0.2, 0.35, 0.5, 0.65, 0.8, 0.9, 1})
    void whiteReflectsAllLightAndNoMore(double roughness) {
        for (double cosine : new double[] {0.01, 0.05, 0.2, 0.5, 0.8, 1}) {
            Vector3d toEye = direction(cosine, 0.3);
            requireAllLight(surface(new Vector3d(1), roughness, 0, toEye), "insulator, " + cosine);
            requireAllLight(surface(new Vector3d(1), roughness, 1, toEye), "metal, " + cosine);
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 0.05, 0.1, 0.2, 0.35, 0.5, 0.65, 0.8, 0.9, 1})
    void noColourReflectsMoreThanAllLight(double roughness) {
        for (double cosine : new double[] {0.01, 0.2, 0.5, 1}) {
            for (Vector3d colour : List.of(new Vector3d(1, 0, 0.5), new Vector3d(1, 0.9, 0.99))) {
                for (double metallic : new double[] {0, 0.5, 1}) {
                    SurfacePoint surface = surface(colour, roughness, metallic, direction(cosine, 0.3));
                    for (int channel = 0; channel < 3; channel++) {
                        Albedo albedo = Albedo.of(surface, channel, SAMPLES / 4);
                        assertTrue(albedo.mean < 1.002 + 4 * albedo.error, colour + ", " + cosine + ": " + albedo);
                    }
                }
            }
        }
    }

    /** The share of light that a surface reflects in one channel, and its standard error. */
    private record Albedo(double mean, double error) {
        static Albedo of(SurfacePoint surface, int channel, int samples) {
            BrdfSampling sampling = new BrdfSampling(surface);
            SplittableRandom random = new SplittableRandom(5);
            double sum = 0;
            double squares = 0;
            for (int i = 0; i < samples; i++) {
                Vector3d towards = sampling.direction(random);
                double weight =
                        towards.y <= 0 ? 0 : surface.reflected(towards).get(channel) / sampling.density(towards);
                sum += weight;
                squares += weight * weight;
            }
            double mean = sum / samples;
            return new Albedo(mean, Math.sqrt(Math.max(0, squares / samples - mean * mean) / samples));
        }
    }

    /** Where one scattering is all but everything, near the horizon the rest is left out. */
    private static void requireAllLight(SurfacePoint surface, String what) {
        Albedo albedo = Albedo.of(surface, 0, SAMPLES);
        boolean isSharp = surface.gloss().alpha2() < 1e-3 && surface.toEye().y() < 0.1;
        assertEquals(1, albedo.mean, 4 * albedo.error + (isSharp ? 0.05 : 0.002), what);
        assertTrue(albedo.mean < 1.002 + 4 * albedo.error, what);
        assertTrue(albedo.error < 0.01, what + ": " + albedo.error);
    }

    /** A density that is not the sampler's would shift every estimate that is divided by it. */
    @ParameterizedTest
    @ValueSource(doubles = {0.15, 0.4, 1})
    void directionsAreAsDenseAsStated(double roughness) {
        SurfacePoint surface = surface(new Vector3d(0.9, 0.6, 0.2), roughness, 0.5, direction(0.6, 0));
        BrdfSampling sampling = new BrdfSampling(surface);
        SplittableRandom random = new SplittableRandom(7);
        int above = 0;
        int near = 0;
        Vector3d middle = direction(0.7, Math.PI);
        for (int i = 0; i < SAMPLES; i++) {
            Vector3d towards = sampling.direction(random);
            above += towards.y > 0 ? 1 : 0;
            near += towards.dot(middle) > 0.9 ? 1 : 0;
        }
        double integral = 0;
        double nearIntegral = 0;
        for (int i = 0; i < SAMPLES; i++) {
            Vector3d towards = direction(random.nextDouble(), 2 * Math.PI * random.nextDouble());
            double density = sampling.density(towards) * 2 * Math.PI / SAMPLES;
            integral += density;
            nearIntegral += towards.dot(middle) > 0.9 ? density : 0;
        }
        double wide = roughness < 0.3 ? 0.15 : 0.04; // a narrow lobe's integral over even directions is noisy
        assertEquals((double) above / SAMPLES, integral, wide);
        assertEquals((double) near / SAMPLES, nearIntegral, wide);
        assertTrue(near > 0);
    }
}
