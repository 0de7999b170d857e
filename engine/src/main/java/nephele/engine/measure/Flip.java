package nephele.engine.measure;

import java.util.Arrays;
import java.util.function.DoubleUnaryOperator;

/**
 * The difference that an observer sees when flipping between two pictures: Andersson, Nilsson, Akenine-Möller,
 * Oskarsson, Åström and Fairchild, "FLIP: A Difference Evaluator for Alternating Images", 2020. Symmetric except for
 * rounding; 0 is equal, 1 is black against white.
 */
public final class Flip {
    /** A display 0.7 m wide with 3 840 pixels, seen from 0.7 m: the authors' default. */
    public static final double PIXELS_PER_DEGREE = 0.7 * (3840 / 0.7) * (Math.PI / 180);

    /** Exponent that compresses large colour differences. */
    private static final double COLOUR_EXPONENT = 0.7;

    /** Differences below this fraction of the greatest one are mapped to {@link #COLOUR_TARGET} of the range. */
    private static final double COLOUR_KNEE = 0.4;

    private static final double COLOUR_TARGET = 0.95;
    private static final double FEATURE_EXPONENT = 0.5;

    private static final Gaussian ACHROMATIC = new Gaussian(1, 0.0047);
    private static final Gaussian RED_GREEN = new Gaussian(1, 0.0053);
    private static final Gaussian[] BLUE_YELLOW = {new Gaussian(34.1, 0.04), new Gaussian(13.5, 0.025)};

    /** Pixels by which the widest Gaussian reaches. */
    private static final int CONTRAST_RADIUS = BLUE_YELLOW[0].radius();

    private static final Kernel ACHROMATIC_KERNEL = ACHROMATIC.kernel();
    private static final Kernel RED_GREEN_KERNEL = RED_GREEN.kernel();
    private static final Kernel[] BLUE_YELLOW_KERNELS = {BLUE_YELLOW[0].kernel(), BLUE_YELLOW[1].kernel()};
    private static final float FIRST_BLUE_YELLOW_WEIGHT =
            (float) (BLUE_YELLOW[0].volume() / (BLUE_YELLOW[0].volume() + BLUE_YELLOW[1].volume()));

    /** The width of an edge detector of human vision. */
    private static final double FEATURE_DEGREES = 0.082;

    private static final double FEATURE_DEVIATION = 0.5 * FEATURE_DEGREES * PIXELS_PER_DEGREE;
    private static final int FEATURE_RADIUS = (int) Math.ceil(3 * FEATURE_DEVIATION);
    private static final Kernel SMOOTH = Kernel.of(FEATURE_RADIUS, x -> gaussian(x / FEATURE_DEVIATION));
    private static final Kernel FIRST_DERIVATIVE = Kernel.of(FEATURE_RADIUS, x -> -x * gaussian(x / FEATURE_DEVIATION));
    private static final Kernel SECOND_DERIVATIVE = Kernel.of(
            FEATURE_RADIUS,
            x -> (x * x / (FEATURE_DEVIATION * FEATURE_DEVIATION) - 1) * gaussian(x / FEATURE_DEVIATION));
    private static final double GREATEST_COLOUR_DIFFERENCE = greatestColourDifference();

    private Flip() {}

    /**
     * Returns the error of each pixel.
     *
     * @param reference linear values from 0 to 1, as emitted by a display
     * @param test likewise, of the same size
     * @throws IllegalArgumentException if the sizes differ
     */
    public static ErrorMap ofDisplayed(LinearPicture reference, LinearPicture test) {
        reference.requireSameSize(test);
        var exact = OpponentPicture.of(reference);
        var tried = OpponentPicture.of(test);
        float[] luminance = lightness(exact);
        float[] triedLuminance = lightness(tried);
        float[] edges = magnitudes(luminance, exact.width(), FIRST_DERIVATIVE);
        float[] triedEdges = magnitudes(triedLuminance, exact.width(), FIRST_DERIVATIVE);
        float[] points = magnitudes(luminance, exact.width(), SECOND_DERIVATIVE);
        float[] triedPoints = magnitudes(triedLuminance, exact.width(), SECOND_DERIVATIVE);
        filterContrast(exact);
        filterContrast(tried);
        float[] exactLab = exact.huntLab();
        float[] triedLab = tried.huntLab();
        float[] error = new float[reference.pixels()];
        for (int i = 0; i < error.length; i++) {
            double colour = colourError(exactLab, triedLab, 3 * i);
            double feature = featureError(edges[i] - triedEdges[i], points[i] - triedPoints[i]);
            error[i] = (float) Math.pow(colour, 1 - feature);
        }
        return new ErrorMap(reference.width(), reference.height(), error);
    }

    /** Returns the HyAB distance (Abasi, Tehran and Fairchild 2020), compressed and mapped to 0–1. */
    private static double colourError(float[] exact, float[] tried, int at) {
        double lightness = Math.abs(exact[at] - tried[at]);
        double difference = Math.pow(
                lightness + Math.hypot(exact[at + 1] - tried[at + 1], exact[at + 2] - tried[at + 2]), COLOUR_EXPONENT);
        double knee = COLOUR_KNEE * GREATEST_COLOUR_DIFFERENCE;
        return difference < knee
                ? COLOUR_TARGET / knee * difference
                : COLOUR_TARGET + (difference - knee) / (GREATEST_COLOUR_DIFFERENCE - knee) * (1 - COLOUR_TARGET);
    }

    private static double featureError(float edges, float points) {
        return Math.pow(Math.max((double) Math.abs(edges), Math.abs(points)) / Math.sqrt(2), FEATURE_EXPONENT);
    }

    /**
     * Filters the three opponent channels in place by the contrast sensitivity of an observer, sums of Gaussians (Andersson
     * et al. 2020, section 4.1.1, after Johnson and Fairchild 2003).
     */
    private static void filterContrast(OpponentPicture picture) {
        float[] rows = new float[picture.y().length];
        ACHROMATIC_KERNEL.inPlace(picture.y(), picture.width(), rows);
        RED_GREEN_KERNEL.inPlace(picture.cx(), picture.width(), rows);
        float[] narrow = picture.cz().clone();
        BLUE_YELLOW_KERNELS[0].inPlace(picture.cz(), picture.width(), rows);
        BLUE_YELLOW_KERNELS[1].inPlace(narrow, picture.width(), rows);
        float[] cz = picture.cz();
        for (int i = 0; i < cz.length; i++) {
            cz[i] = FIRST_BLUE_YELLOW_WEIGHT * cz[i] + (1 - FIRST_BLUE_YELLOW_WEIGHT) * narrow[i];
        }
    }

    private static double gaussian(double x) {
        return Math.exp(-x * x / 2);
    }

    private static float[] lightness(OpponentPicture picture) {
        float[] lightness = picture.y().clone();
        for (int i = 0; i < lightness.length; i++) {
            lightness[i] = (lightness[i] + 16) / 116;
        }
        return lightness;
    }

    /**
     * Returns the strength of edges or points at each pixel, 0–1: the magnitude of the first or second derivative of a
     * Gaussian (Andersson et al. 2020, section 4.2).
     */
    private static float[] magnitudes(float[] lightness, int width, Kernel derivative) {
        float[] rows = new float[lightness.length];
        float[] across = new float[lightness.length];
        float[] along = new float[lightness.length];
        derivative.alongRows(lightness, width, rows);
        SMOOTH.alongColumns(rows, width, along);
        SMOOTH.alongRows(lightness, width, rows);
        derivative.alongColumns(rows, width, across);
        for (int i = 0; i < along.length; i++) {
            along[i] = (float) Math.sqrt(along[i] * along[i] + across[i] * across[i]);
        }
        return along;
    }

    /** Returns the compressed distance of green and blue, the most different colours of a display. */
    private static double greatestColourDifference() {
        double[] green = lab(0, 1, 0);
        double[] blue = lab(0, 0, 1);
        double lightness = Math.abs(green[0] - blue[0]);
        return Math.pow(lightness + Math.hypot(green[1] - blue[1], green[2] - blue[2]), COLOUR_EXPONENT);
    }

    private static double[] lab(double red, double green, double blue) {
        double[] lab = new double[3];
        Colorimetry.huntLab(
                Colorimetry.relativeX(red, green, blue),
                Colorimetry.relativeY(red, green, blue),
                Colorimetry.relativeZ(red, green, blue),
                lab);
        return lab;
    }

    /** A Gaussian a·√(π/b)·exp(−π²x²/b), x in degrees of visual angle. */
    private record Gaussian(double a, double b) {
        double weight(double pixels) {
            double degrees = pixels / PIXELS_PER_DEGREE;
            return Math.exp(-Math.PI * Math.PI * degrees * degrees / b);
        }

        int radius() {
            return (int) Math.ceil(3 * Math.sqrt(b / (2 * Math.PI * Math.PI)) * PIXELS_PER_DEGREE);
        }

        Kernel kernel() {
            return Kernel.of(Math.min(CONTRAST_RADIUS, 2 * radius()), this::weight);
        }

        /** Returns the sum of the unnormalised weights of the two-dimensional filter. */
        double volume() {
            double sum = 0;
            for (int pixel = -CONTRAST_RADIUS; pixel <= CONTRAST_RADIUS; pixel++) {
                sum += weight(pixel);
            }
            return a * Math.sqrt(Math.PI / b) * sum * sum;
        }
    }

    /**
     * The weights of a separable filter in one dimension, centred. Positive and negative weights are normalised separately.
     *
     * @param weights an odd number
     */
    private record Kernel(float[] weights) {
        static Kernel of(int radius, DoubleUnaryOperator weight) {
            double[] raw = new double[2 * radius + 1];
            double positive = 0;
            double negative = 0;
            for (int i = 0; i < raw.length; i++) {
                raw[i] = weight.applyAsDouble(i - radius);
                positive += Math.max(raw[i], 0);
                negative -= Math.min(raw[i], 0);
            }
            float[] weights = new float[raw.length];
            for (int i = 0; i < raw.length; i++) {
                weights[i] = (float) (raw[i] > 0 ? raw[i] / positive : raw[i] < 0 ? raw[i] / negative : 0);
            }
            return new Kernel(weights);
        }

        int radius() {
            return weights.length / 2;
        }

        /** Filters each row of {@code from}; beyond the border the border's value is repeated. */
        void alongRows(float[] from, int width, float[] to) {
            int radius = radius();
            float[] padded = new float[width + 2 * radius];
            float[] sum = new float[width];
            for (int row = 0; row < from.length; row += width) {
                Arrays.fill(padded, 0, radius, from[row]);
                System.arraycopy(from, row, padded, radius, width);
                Arrays.fill(padded, radius + width, padded.length, from[row + width - 1]);
                Arrays.fill(sum, 0);
                for (int k = 0; k < weights.length; k++) {
                    addScaled(padded, k, weights[k], sum, 0, width);
                }
                System.arraycopy(sum, 0, to, row, width);
            }
        }

        /** Filters each column as {@link #alongRows}; {@code to} must not be {@code from}. */
        void alongColumns(float[] from, int width, float[] to) {
            int radius = radius();
            int height = from.length / width;
            Arrays.fill(to, 0);
            for (int row = 0; row < height; row++) {
                for (int k = 0; k < weights.length; k++) {
                    int source = Math.min(Math.max(row + k - radius, 0), height - 1);
                    addScaled(from, source * width, weights[k], to, row * width, width);
                }
            }
        }

        /** Filters rows and columns. */
        void inPlace(float[] channel, int width, float[] rows) {
            alongRows(channel, width, rows);
            alongColumns(rows, width, channel);
        }

        private static void addScaled(float[] from, int fromStart, float weight, float[] to, int toStart, int count) {
            for (int i = 0; i < count; i++) {
                to[toStart + i] += weight * from[fromStart + i];
            }
        }
    }

    /**
     * A picture in the linear opponent space YyCxCz (Monga, Geisler and Bovik 2010): achromatic, red–green, blue–yellow.
     *
     * @param y −16 at black, 100 at white
     */
    private record OpponentPicture(int width, float[] y, float[] cx, float[] cz) {
        static OpponentPicture of(LinearPicture picture) {
            int pixels = picture.pixels();
            var opponent =
                    new OpponentPicture(picture.width(), new float[pixels], new float[pixels], new float[pixels]);
            float[] rgb = picture.rgb();
            for (int i = 0; i < pixels; i++) {
                double x = Colorimetry.relativeX(rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]);
                double y = Colorimetry.relativeY(rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]);
                double z = Colorimetry.relativeZ(rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]);
                opponent.y[i] = (float) (116 * y - 16);
                opponent.cx[i] = (float) (500 * (x - y));
                opponent.cz[i] = (float) (200 * (y - z));
            }
            return opponent;
        }

        /** Returns CIELAB with the chroma of Hunt's effect (brighter colours look more colourful), three values a pixel. */
        float[] huntLab() {
            float[] lab = new float[3 * y.length];
            double[] colour = new double[3];
            for (int i = 0; i < y.length; i++) {
                double relativeY = (y[i] + 16.0) / 116;
                double relativeX = relativeY + cx[i] / 500.0;
                double relativeZ = relativeY - cz[i] / 200.0;
                Colorimetry.huntLab(relativeX, relativeY, relativeZ, colour);
                for (int channel = 0; channel < 3; channel++) {
                    lab[3 * i + channel] = (float) colour[channel];
                }
            }
            return lab;
        }
    }
}
