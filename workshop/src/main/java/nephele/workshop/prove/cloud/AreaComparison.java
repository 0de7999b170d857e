package nephele.workshop.prove.cloud;

/** The differences of a traced part of a picture from the reference. */
final class AreaComparison {
    private static final double MOST_SIGMAS = 5;

    /** Difference from the sky by which a pixel sees the cloud; more than the rounding of either picture. */
    private static final double LEAST_OF_CLOUD = 1e-6;

    private final TracedArea area;
    private final float[] traced;
    private final float[] error;

    AreaComparison(TracedArea area) {
        this.area = area;
        traced = area.picture().rgb();
        error = area.picture().standardError();
    }

    /** The difference of the mean radiance of a channel. */
    record Bias(double fraction, double sigmas) {}

    /** Returns the difference of the means, as a fraction of the reference's and in units of their joint standard error. */
    Bias bias(int channel) {
        double sum = 0;
        double expected = 0;
        double variance = 0;
        for (int pixel = 0; pixel < area.pixels(); pixel++) {
            sum += traced[3 * pixel + channel];
            expected += reference(pixel, channel);
            variance += jointVariance(pixel, channel);
        }
        double difference = sum - expected;
        return new Bias(difference / expected, difference == 0 ? 0 : difference / Math.sqrt(variance));
    }

    /** Returns the number of pixels that see the cloud. */
    int cloudy() {
        int count = 0;
        for (int pixel = 0; pixel < area.pixels(); pixel++) {
            count += seesCloud(pixel) ? 1 : 0;
        }
        return count;
    }

    private boolean seesCloud(int pixel) {
        for (int channel = 0; channel < 3; channel++) {
            double sky = area.scene().sky().toVector().get(channel);
            if (Math.abs(traced[3 * pixel + channel] - sky) > LEAST_OF_CLOUD
                    || Math.abs(reference(pixel, channel) - sky) > LEAST_OF_CLOUD) {
                return true;
            }
        }
        return false;
    }

    /** Returns the number of pixels that see the cloud and differ by more than 5 standard errors in a channel. */
    int differing() {
        int count = 0;
        for (int pixel = 0; pixel < area.pixels(); pixel++) {
            count += seesCloud(pixel) && sigmas(pixel) > MOST_SIGMAS ? 1 : 0;
        }
        return count;
    }

    /** Returns the root of the mean squared difference in units of its standard error, over the pixels with cloud. */
    double spread() {
        double sum = 0;
        for (int pixel = 0; pixel < area.pixels(); pixel++) {
            if (seesCloud(pixel)) {
                double difference = traced[3 * pixel] - reference(pixel, 0);
                sum += difference * difference / jointVariance(pixel, 0);
            }
        }
        return Math.sqrt(sum / cloudy());
    }

    private double sigmas(int pixel) {
        double most = 0;
        for (int channel = 0; channel < 3; channel++) {
            double difference = Math.abs(traced[3 * pixel + channel] - reference(pixel, channel));
            most = Math.max(most, difference / Math.sqrt(jointVariance(pixel, channel)));
        }
        return most;
    }

    private double jointVariance(int pixel, int channel) {
        double ofReference = area.scene().error().rgb()[3 * area.inWhole(pixel) + channel];
        double ours = error[3 * pixel + channel];
        return ofReference * ofReference + ours * ours;
    }

    private double reference(int pixel, int channel) {
        return area.scene().radiance().rgb()[3 * area.inWhole(pixel) + channel];
    }
}
