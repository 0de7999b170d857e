package nephele.engine.cloud.light;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SlabDoublingTest {
    private static final double[] COSINES = {1, 0.5, 0.1};
    private static final int DOUBLINGS = 22;

    private static SlabDoubling slab(double albedo, double g, double thickness) {
        var slab = new SlabDoubling(CloudOptics.of(albedo, g), thickness / (1 << DOUBLINGS), COSINES);
        for (int doubling = 0; doubling < DOUBLINGS; doubling++) {
            slab.addToItself();
        }
        return slab;
    }

    /** By adding-doubling of another program with 100 directions (slab_truth.csv). */
    @ParameterizedTest
    @CsvSource({
        "0, 1, .341329, .498376, .697664",
        "0, 16, .903631, .933294, .958661",
        "0.85, 0.5, .019927, .087080, .470671",
        "0.85, 1, .042316, .164878, .545797",
        "0.85, 8, .358432, .558078, .762380",
        "0.85, 64, .846281, .894970, .943498"
    })
    void aConservativeSlabReflectsWhatItShouldAndPassesTheRest(
            double g, double thickness, double upright, double slanted, double grazing) {
        SlabDoubling slab = slab(1, g, thickness);
        double[] exact = {upright, slanted, grazing};
        for (int beam = 0; beam < COSINES.length; beam++) {
            assertEquals(exact[beam], slab.reflectance(beam), 3e-4, "reflectance at " + COSINES[beam]);
            assertEquals(1, slab.reflectance(beam) + slab.transmittance(beam), 1e-6, "energy at " + COSINES[beam]);
        }
    }

    @ParameterizedTest
    @CsvSource({
        "0.999, 0.85, 1, .042160, .956656",
        "0.999, 0.85, 8, .352121, .632506",
        "0.999, 0.85, 32, .687107, .241972",
        "0.99, 0, 1, .332922, .650978",
        "0.99, 0, 8, .728750, .122068",
        "0.99, 0, 32, .752715, .001868"
    })
    void anAbsorbingSlabReflectsAndPassesWhatItShould(
            double albedo, double g, double thickness, double reflectance, double transmittance) {
        SlabDoubling slab = slab(albedo, g, thickness);
        assertEquals(reflectance, slab.reflectance(0), 3e-4);
        assertEquals(transmittance, slab.transmittance(0), 3e-4);
    }
}
