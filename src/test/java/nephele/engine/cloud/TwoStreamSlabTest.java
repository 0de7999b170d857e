package nephele.engine.cloud;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import nephele.engine.cloud.light.CloudOptics;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;

/** Delta-Eddington fluxes are near those of adding-doubling, keep energy, and are finite at every limit. */
class TwoStreamSlabTest {
    private static DeltaScaling medium(double albedo, double g) {
        return CloudOptics.of(albedo, g).scaled();
    }

    private static final String TRUTH = "/nephele/workshop/prove/cloud/slab_truth.csv";

    /** Greatest errors of both fluxes by the cosine of the beam, for asymmetry 0.85 and for the smaller ones. */
    private static final Map<Double, Double> FORWARD =
            Map.of(1.0, 0.006, 0.75, 0.0125, 0.5, 0.03, 0.25, 0.075, 0.1, 0.145);

    private static final Map<Double, Double> MILD = Map.of(1.0, 0.012, 0.75, 0.013, 0.5, 0.02, 0.25, 0.035, 0.1, 0.05);

    /** Columns: albedo, g, tau, mu0, R, T, direct T, diffuse R, diffuse T. */
    static List<double[]> truth() throws IOException {
        try (var in = TwoStreamSlabTest.class.getResourceAsStream(TRUTH);
                var lines = new BufferedReader(new InputStreamReader(in, StandardCharsets.US_ASCII))) {
            return lines.lines()
                    .skip(1)
                    .map(line -> Arrays.stream(line.split(","))
                            .mapToDouble(Double::parseDouble)
                            .toArray())
                    .toList();
        }
    }

    @Test
    void allRowsOfAddingDoublingAreNear() throws IOException {
        assertEquals(360, truth().size());
        for (double[] row : truth()) {
            double allowed = (row[1] > 0.5 ? FORWARD : MILD).get(row[3]);
            var slab = TwoStreamSlab.underBeam(medium(row[0], row[1]), row[2], row[3]);
            assertEquals(row[4], slab.reflectance(), allowed, Arrays.toString(row));
            assertEquals(row[5], slab.transmittance(), allowed, Arrays.toString(row));
        }
    }

    /** Plane albedos at normal incidence, asymmetry 0.85, no absorption, rounded to four digits. */
    @ParameterizedTest
    @CsvSource({"1, .0467", "4, .1948", "8, .3564", "16, .5546", "32, .7283", "64, .8476"})
    void aConservativeSlabHasThePublishedForm(double depth, double reflectance) {
        assertEquals(
                reflectance, TwoStreamSlab.underBeam(medium(1, 0.85), depth, 1).reflectance(), 6e-5);
        double scaled = (1 - 0.85 * 0.85) * depth;
        double g = 0.85 / 1.85;
        double gamma1 = 0.75 * (1 - g);
        double gamma3 = (2 - 3 * g) / 4;
        double closed = (gamma1 * scaled + (gamma3 - gamma1) * (1 - Math.exp(-scaled))) / (1 + gamma1 * scaled);
        assertEquals(closed, TwoStreamSlab.underBeam(medium(1, 0.85), depth, 1).reflectance(), 1e-13);
    }

    static Stream<double[]> extremes() {
        return Stream.of(0, 1e-300, 0.3, 0.9, 0.999, 1 - 1e-12, 1)
                .flatMap(albedo -> Stream.of(-0.999, 0.0, 0.85, 0.999, 1.0)
                        .flatMap(g -> Stream.of(0.0, 1e-300, 1e-8, 1e-3, 1.0, 1e4, 1e9)
                                .flatMap(depth -> Stream.of(0.0, 1e-9, 0.01, 0.5, 1.0)
                                        .map(cosine -> new double[] {albedo.doubleValue(), g, depth, cosine}))));
    }

    @Test
    void noLimitMakesLightOrLosesIt() {
        extremes().forEach(at -> {
            var slab = TwoStreamSlab.underBeam(medium(at[0], at[1]), at[2], at[3]);
            double reflected = slab.reflectance();
            double transmitted = slab.transmittance();
            boolean isShare = reflected >= -1e-12 && transmitted >= -1e-12 && reflected + transmitted <= 1 + 1e-9;
            assertTrue(isShare, Arrays.toString(at) + ": " + reflected + ", " + transmitted);
            if (at[0] == 1) {
                assertEquals(1, reflected + transmitted, 1e-7, Arrays.toString(at));
            }
            assertTrue(slab.diffuseFluence(at[2] / 3) >= -1e-9, Arrays.toString(at));
        });
    }

    @Test
    void aSlabOfNoDepthOrNoScatteringOnlyLetsThrough() {
        assertEquals(0, TwoStreamSlab.underBeam(medium(1, 0.85), 0, 0.5).reflectance(), 1e-15);
        assertEquals(1, TwoStreamSlab.underBeam(medium(1, 0.85), 0, 0.5).transmittance(), 1e-15);
        assertEquals(0, TwoStreamSlab.underBeam(medium(0, 0.85), 3, 0.5).reflectance(), 1e-15);
        assertEquals(
                Math.exp(-6), TwoStreamSlab.underBeam(medium(0, 0.85), 3, 0.5).transmittance(), 1e-15);
    }

    /** At k = 1/mu0 the textbook's form is 0/0; here its neighbours and it lie on one line. */
    @ParameterizedTest
    @MethodSource("resonances")
    void nothingHappensAtTheResonance(double albedo, double g, double depth) {
        DeltaScaling medium = medium(albedo, g);
        double k = Math.sqrt(3 * (1 - medium.albedo()) * (1 - medium.albedo() * medium.g()));
        double cosine = 1 / k;
        double before =
                TwoStreamSlab.underBeam(medium(albedo, g), depth, cosine - 1e-4).reflectance();
        double after =
                TwoStreamSlab.underBeam(medium(albedo, g), depth, cosine + 1e-4).reflectance();
        for (double off : new double[] {0, 1e-15, 1e-12, 1e-9, -1e-7}) {
            assertEquals(
                    (before + after) / 2,
                    TwoStreamSlab.underBeam(medium(albedo, g), depth, cosine + off)
                            .reflectance(),
                    1e-7);
        }
    }

    static Stream<Arguments> resonances() {
        return Stream.of(Arguments.of(0.4, 0.0, 2.0), Arguments.of(0.1, 0.3, 0.01), Arguments.of(0.3, 0.85, 50.0));
    }

    /** The light that leaves neither above nor below is the fluence times the absorption, summed over the depth. */
    @Test
    void theFluenceIsWhatIsAbsorbed() {
        for (double cosine : new double[] {0.1, 0.5, 1}) {
            for (double depth : new double[] {0.1, 3, 40}) {
                var slab = TwoStreamSlab.underBeam(medium(0.99, 0.85), depth, cosine);
                DeltaScaling medium = medium(0.99, 0.85);
                int steps = 20_000;
                double absorbed = 0;
                for (int i = 0; i < steps; i++) {
                    double at = depth * (i + 0.5) / steps;
                    double beam = Math.exp(-medium.depthFactor() * at / cosine) / cosine;
                    absorbed += (1 - medium.albedo())
                            * (slab.diffuseFluence(at) + beam)
                            * medium.depthFactor()
                            * depth
                            / steps;
                }
                assertEquals(1 - slab.reflectance() - slab.transmittance(), absorbed, 2e-6);
            }
        }
    }

    @Test
    void fluxesMeetTheirBoundaries() {
        var slab = TwoStreamSlab.underBeam(medium(0.999, 0.85), 12, 0.6);
        assertEquals(0, downward(slab, 0), 1e-14);
        double direct = Math.exp(-medium(0.999, 0.85).depthFactor() * 12 / 0.6);
        assertEquals(slab.transmittance() - direct, downward(slab, 12), 1e-14);
        assertEquals(2 * slab.reflectance(), slab.diffuseFluence(0), 1e-14);
    }

    private static double downward(TwoStreamSlab slab, double depth) {
        return (slab.diffuseFluence(depth) / 2 + slab.diffuseNetFlux(depth)) / 2;
    }

    /** Semi-infinite, for an upright beam: the reflectance of adding-doubling is 0.7873. */
    @Test
    void aDeepSlabReflectsWhatItDoesNotAbsorb() {
        var slab = TwoStreamSlab.underBeam(medium(0.999, 0.85), 1e5, 1);
        assertEquals(0.7873, slab.reflectance(), 0.006);
        assertEquals(0, slab.transmittance(), 1e-12);
    }

    /** Deep inside a conservative slab the fluence falls on a straight line to the bottom. */
    @Test
    void lightDiffusesThroughADeepSlab() {
        var slab = TwoStreamSlab.underBeam(medium(1, 0.85), 1000, 1);
        double step = slab.diffuseFluence(400) - slab.diffuseFluence(500);
        assertEquals(step, slab.diffuseFluence(800) - slab.diffuseFluence(900), 1e-9);
        assertEquals(3 * (1 - 0.85) * 100 * slab.transmittance(), step, 1e-9);
        assertEquals(0.01119, slab.transmittance(), 2e-4);
    }
}
