package nephele.lab.prove.cloud;

/** The differences of a traced tile from the reference. */
final class TileComparison {
    private static final double MOST_SIGMAS = 5;

    private final ReferenceCase scene;
    private final TracedTile tile;

    TileComparison(ReferenceCase scene, TracedTile tile) {
        this.scene = scene;
        this.tile = tile;
    }

    /** The difference of the mean radiance of a channel. */
    record Bias(double share, double sigmas) {}

    /** Returns the difference of the means, as a share of the reference's and in units of their joint standard error. */
    Bias bias(int channel) {
        double traced = 0;
        double reference = 0;
        double variance = 0;
        for (int pixel = 0; pixel < tile.pixels(); pixel++) {
            traced += tile.mean(pixel, channel);
            reference += reference(pixel, channel);
            variance += jointVariance(pixel, channel);
        }
        double difference = traced - reference;
        return new Bias(difference / reference, difference == 0 ? 0 : difference / Math.sqrt(variance));
    }

    /** Returns the number of pixels that see the cloud. */
    int cloudy() {
        int count = 0;
        for (int pixel = 0; pixel < tile.pixels(); pixel++) {
            count += tile.meetsCloud(pixel) ? 1 : 0;
        }
        return count;
    }

    /** Returns the number of pixels that see the cloud and differ by more than 5 standard errors in a channel. */
    int differing() {
        int count = 0;
        for (int pixel = 0; pixel < tile.pixels(); pixel++) {
            count += tile.meetsCloud(pixel) && sigmas(pixel) > MOST_SIGMAS ? 1 : 0;
        }
        return count;
    }

    /** Returns the root of the mean squared difference in units of its standard error, over the pixels with cloud. */
    double spread() {
        double sum = 0;
        for (int pixel = 0; pixel < tile.pixels(); pixel++) {
            if (tile.meetsCloud(pixel)) {
                double difference = tile.mean(pixel, 0) - reference(pixel, 0);
                sum += difference * difference / jointVariance(pixel, 0);
            }
        }
        return Math.sqrt(sum / cloudy());
    }

    private double sigmas(int pixel) {
        double most = 0;
        for (int channel = 0; channel < 3; channel++) {
            double difference = Math.abs(tile.mean(pixel, channel) - reference(pixel, channel));
            most = Math.max(most, difference / Math.sqrt(jointVariance(pixel, channel)));
        }
        return most;
    }

    private double jointVariance(int pixel, int channel) {
        double error = scene.error().rgb()[3 * tile.inPicture(pixel) + channel];
        return error * error + tile.variance(pixel, channel);
    }

    private double reference(int pixel, int channel) {
        return scene.radiance().rgb()[3 * tile.inPicture(pixel) + channel];
    }
}
