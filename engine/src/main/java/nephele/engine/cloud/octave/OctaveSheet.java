package nephele.engine.cloud.octave;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import nephele.engine.level.Cloud;

/**
 * A cloud as octaves of noise in the plane: what exceeds a threshold, times a factor, is the vertical optical depth. The
 * threshold leaves the cloud's coverage, the factor its mean optical depth (Elias, Pallister 2001: density 1 − exp(−k c)
 * is Beer's law with optical depth k c).
 *
 * @param octaves the widest first
 * @param variances of the octaves, weights included
 * @param threshold above which there is cloud
 * @param greatest excess that is expected
 * @param greatestDepth optical depth of the greatest excess
 */
public record OctaveSheet(
        List<NoiseOctave> octaves, List<Double> variances, double threshold, double greatest, double greatestDepth) {
    /** Samples along each side from which threshold and factor follow. */
    private static final int SAMPLES = 192;
    /** Distance of samples in cells of the widest octave: they fall on all parts of a cell. */
    private static final double SPACING_CELLS = 1.1618034;

    private static final double USUAL_COVERAGE = 0.5;
    /** Widest cells relative to the size of billows. */
    private static final double CELL_FEATURES = 2;

    /** @param meanDepth optical depth of a column of the cloud, on the mean */
    public static OctaveSheet of(Cloud cloud, ProceduralNoise kind, double heightMetres, double meanDepth) {
        boolean isNoise = cloud.density() instanceof Cloud.Density.Noise;
        var noise = isNoise ? (Cloud.Density.Noise) cloud.density() : null;
        double feature = isNoise ? noise.featureMetres() : heightMetres;
        List<NoiseOctave> octaves = new ArrayList<>();
        for (int i = 0; i < kind.weights().size(); i++) {
            double half = Math.pow(0.5, i);
            octaves.add(new NoiseOctave(
                    kind.isSmooth(),
                    i,
                    CELL_FEATURES * feature * half,
                    kind.weights().get(i),
                    cloud.motion().evolutionSeconds() * half,
                    isNoise ? noise.seed() : 0));
        }
        return measured(List.copyOf(octaves), isNoise ? noise.coverage() : USUAL_COVERAGE, meanDepth);
    }

    private static OctaveSheet measured(List<NoiseOctave> octaves, double coverage, double meanDepth) {
        double[] sums = new double[SAMPLES * SAMPLES];
        List<Double> variances = new ArrayList<>();
        double spacing = SPACING_CELLS * octaves.get(0).cellMetres();
        for (NoiseOctave octave : octaves) {
            double squares = 0;
            for (int n = 0; n < sums.length; n++) {
                double value = octave.weight() * octave.at(spacing * (n % SAMPLES), spacing * (n / SAMPLES), 0);
                sums[n] += value;
                squares += value * value;
            }
            variances.add(squares / sums.length);
        }
        Arrays.sort(sums);
        double threshold = sums[(int) Math.round((1 - coverage) * (sums.length - 1))];
        double excess = 0;
        for (double sum : sums) {
            excess += Math.max(0, sum - threshold) / sums.length;
        }
        double greatest = sums[sums.length - 1] - threshold;
        double factor = excess > 0 ? meanDepth / excess : 0;
        return new OctaveSheet(
                octaves,
                List.copyOf(variances),
                threshold,
                Math.max(greatest, 1e-6),
                factor * Math.max(greatest, 1e-6));
    }

    /** Returns the optical depth of a column, relative to the greatest, at a place that drifts with the cloud. */
    public double at(double x, double z, double seconds) {
        double sum = -threshold;
        for (NoiseOctave octave : octaves) {
            sum += octave.weight() * octave.at(x, z, seconds);
        }
        return Math.max(0, sum) / greatest;
    }

    /** Returns the edge of the widest cells. */
    public double cellMetres() {
        return octaves.get(0).cellMetres();
    }
}
