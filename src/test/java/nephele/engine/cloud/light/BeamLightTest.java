package nephele.engine.cloud.light;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.cloud.HenyeyGreenstein;
import nephele.engine.render.frame.Quality.PuffLight;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Light along the beam does not depend on how many particles share an optical depth, and is never more than the sun's. */
class BeamLightTest {
    private static final CloudOptics PEAKED = CloudOptics.of(1, 0.85);

    @ParameterizedTest
    @ValueSource(doubles = {-0.999, -0.5, 0, 1e-12, 0.3, 0.85, 0.99, 0.999})
    void theShareInAConeIsTheIntegral(double g) {
        var phase = new HenyeyGreenstein(g);
        int steps = 20_000;
        double edge = 0.7;
        double sum = 0;
        for (int i = 0; i < steps; i++) {
            double low = edge * Math.pow((double) i / steps, 4);
            double high = edge * Math.pow((i + 1.0) / steps, 4);
            sum += Math.PI * (high - low) * phase.perSteradian((low + high) / 2);
        }
        assertEquals(sum, phase.fractionWithin(edge), 5e-6);
        assertEquals(0, phase.fractionWithin(0));
        assertEquals(1, phase.fractionWithin(4), 1e-9);
    }

    @Test
    void theBeamIsNeverMoreThanTheSun() {
        for (double albedo : new double[] {0, 0.5, 1}) {
            for (double g : new double[] {-0.999, 0, 0.85, 0.999}) {
                double fading = BeamLight.forwards(CloudOptics.of(albedo, g)).fading();
                assertTrue(fading >= 0 && fading <= 1, albedo + ", " + g + ": " + fading);
            }
        }
        assertEquals(1, BeamLight.once(PEAKED).fading());
        assertEquals(0.649, BeamLight.forwards(PEAKED).fading(), 5e-4);
    }

    /** Particles of equal depth between sun and eye, seen along the beam: the light that is left, and the radiance. */
    private record Blended(double left, double radiance) {
        static Blended of(BeamLight light, double depth, int particles, double separation) {
            double each = depth / particles;
            double seen = 1;
            double left = 1;
            double radiance = 0;
            for (int k = 0; k < particles; k++) {
                double mean = mean(each + light.fading() * each) / mean(each);
                radiance += seen * -Math.expm1(-each) * mean * light.perDepth(separation, k * each);
                seen *= Math.exp(-each);
                left *= light.irradiance(each);
            }
            return new Blended(left, radiance);
        }

        /** Returns the mean of exp(−t) for t from 0 to a number. */
        private static double mean(double to) {
            return to < 1e-8 ? 1 - to / 2 : -Math.expm1(-to) / to;
        }
    }

    @ParameterizedTest
    @EnumSource(
            value = PuffLight.class,
            names = {"DOBASHI", "HARRIS"})
    void theNumberOfParticlesChangesNothing(PuffLight model) {
        BeamLight light = model.beam(PEAKED);
        for (double depth : new double[] {1e-6, 0.1, 1, 10, 1e4}) {
            Blended one = Blended.of(light, depth, 1, 3);
            for (int particles : new int[] {2, 16, 1000}) {
                Blended many = Blended.of(light, depth, particles, 3);
                assertEquals(one.left, many.left, 1e-6);
                assertEquals(1, many.radiance / one.radiance, 0.01);
            }
        }
    }

    /** Light reflected straight back by a slab that scatters once evenly: knowledge of {@code clouds.md}, 2.2, row 3. */
    @ParameterizedTest
    @CsvSource({"0.01, .000787869756", "0.1, .00721247417", "1, .0344039159", "10, .0397887357", "1e4, .0397887358"})
    void singleScatteringIsThatOfTheSlab(double depth, double expected) {
        BeamLight light = BeamLight.once(CloudOptics.of(1, 0));
        assertEquals(1, Blended.of(light, depth, 7, 4).radiance / expected, 1e-8);
    }

    /** The recurrence of 2001: one factor e^−τ + ω τ p(0) γ a particle. */
    private static double recurrence(CloudOptics optics, double depth, int particles) {
        double each = depth / particles;
        double gain = optics.albedo() * optics.perSteradian(0) * BeamLight.CONE_STERADIANS;
        return Math.pow(Math.exp(-each) + gain * each, particles);
    }

    @Test
    void theRecurrenceOfManyParticlesIsTheExponential() {
        CloudOptics even = CloudOptics.of(0.9, 0);
        assertEquals(1, recurrence(even, 8, 100_000) / BeamLight.forwards(even).irradiance(8), 1e-3);
        assertTrue(recurrence(even, 8, 4) / recurrence(even, 8, 8) > 1.2, "depends on the number");
        assertTrue(recurrence(PEAKED, 8, 1) > 5, "more than the sun's");
    }
}
