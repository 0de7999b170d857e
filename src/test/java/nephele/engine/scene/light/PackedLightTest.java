package nephele.engine.scene.light;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import nephele.engine.math.Vec3;
import nephele.engine.scene.light.bake.LightSamples;
import org.junit.jupiter.api.Test;

class PackedLightTest {
    private static final Vec3 UP = new Vec3(0, 1, 0);

    /** Returns a normal at an angle to {@link #UP}. */
    private static Vec3 tilted(double radians) {
        return new Vec3(Math.sin(radians), Math.cos(radians), 0);
    }

    /** A step is 1/512 to 1/256 of the largest number, and numbers up to 65,408 come back. */
    @Test
    void aWordHoldsThreeNumbersToHalfAStepOfTheLargest() {
        SplittableRandom random = new SplittableRandom(1);
        for (int i = 0; i < 20_000; i++) {
            double scale = Math.scalb(1, random.nextInt(-13, 16));
            Vec3 v = new Vec3(random.nextDouble(), random.nextDouble(), random.nextDouble()).scaled(scale);
            Vec3 back = PackedLight.unpacked(PackedLight.packed(v.x(), v.y(), v.z()));
            double most = Math.max(v.x(), Math.max(v.y(), v.z()));
            double step = Math.max(most / 256, Math.scalb(1, -24));
            assertEquals(v.x(), back.x(), step / 2 * 1.001);
            assertEquals(v.y(), back.y(), step / 2 * 1.001);
            assertEquals(v.z(), back.z(), step / 2 * 1.001);
        }
    }

    @Test
    void extremesAreKeptOrLimited() {
        assertEquals(Vec3.ZERO, PackedLight.unpacked(PackedLight.packed(0, -1, 0)));
        assertEquals(new Vec3(65408, 0, 1024), PackedLight.unpacked(PackedLight.packed(1e9, 0, 1024)));
        // Rounding up reaches the next power of two.
        assertEquals(new Vec3(1, 0, 0), PackedLight.unpacked(PackedLight.packed(0.99999, 0, 0)));
    }

    /** Light from one direction: mean radiance 1, so a facing plane has 4, a plane at 90° 1/8 of that (exact: 0). */
    @Test
    void oneDirectionIsExactForTheFacingPlaneAndItsBack() {
        assertEquals(4, PackedLight.relativeIrradiance(UP, UP), 1e-9);
        assertEquals(0.5, PackedLight.relativeIrradiance(UP, tilted(Math.PI / 2)), 1e-9);
        assertEquals(0, PackedLight.relativeIrradiance(UP, UP.negated()), 1e-9);
    }

    /** An even sky over a plane has mean radiance ½ and mean direction ½ up: 1.17 times its irradiance. */
    @Test
    void anEvenSkyIsOneSixthTooBright() {
        assertEquals(7 / 6.0, 0.5 * PackedLight.relativeIrradiance(UP.scaled(0.5), UP), 1e-9);
    }

    @Test
    void itsMeanOverAllNormalsIsOne() {
        for (double r = 0; r <= 1; r += 0.125) {
            double sum = 0;
            for (int i = 0; i < 4000; i++) {
                double cosine = 2 * (i + 0.5) / 4000 - 1;
                sum += PackedLight.relativeIrradiance(UP.scaled(r), tilted(Math.acos(cosine))) / 4000;
            }
            assertEquals(1, sum, 1e-5, "r " + r);
        }
    }

    /**
     * Mixtures of an even sky and one direction within 60° of the plane's normal, for normals that are tilted by up to 30°:
     * the ratio errs by 0.8 % in the mean and by 2.7 % in the root mean square.
     */
    @Test
    void theRatioToTheOwnNormalIsWrongByThreePercent() {
        SplittableRandom random = new SplittableRandom(2);
        double sum = 0;
        double squares = 0;
        int count = 4000;
        for (int i = 0; i < count; i++) {
            double beam = random.nextDouble();
            double elevation = Math.acos(1 - random.nextDouble() / 2);
            double azimuth = 2 * Math.PI * random.nextDouble();
            Vec3 towards = new Vec3(
                    Math.sin(elevation) * Math.cos(azimuth),
                    Math.cos(elevation),
                    Math.sin(elevation) * Math.sin(azimuth));
            Vec3 n = tilted(Math.toRadians(30) * random.nextDouble());
            LightSamples samples = LightSamples.black(1);
            // A sky of radiance 1 - beam, and a beam whose radiance times solid angle / π is beam.
            double[] moments = {
                beam / 4 * towards.x(),
                (1 - beam) / 4 + beam / 4 * towards.y(),
                beam / 4 * towards.z(),
                (1 - beam) / 2 + beam / 4
            };
            for (int c = 0; c < 4; c++) {
                samples.moments()[c] = (float) moments[c];
            }
            Vec3 d = PackedLight.direction(samples, 0);
            double ofOwn = skyShare(UP) * (1 - beam) + beam * towards.dot(UP);
            double exact = skyShare(n) * (1 - beam) + beam * Math.max(towards.dot(n), 0);
            double ratio = PackedLight.relativeIrradiance(d, n) / PackedLight.relativeIrradiance(d, UP);
            double error = ofOwn * ratio / exact - 1;
            sum += error / count;
            squares += error * error / count;
        }
        assertTrue(Math.abs(sum) < 0.015, "bias " + sum);
        assertTrue(Math.sqrt(squares) < 0.04, "rms " + Math.sqrt(squares));
    }

    /** Returns the part of an even upper hemisphere's light that a tilted plane gets. */
    private static double skyShare(Vec3 n) {
        return 0.5 + 0.5 * n.y();
    }
}
