package nephele.engine.atmosphere;

/**
 * The light in the air as moments of its direction, and the irradiance of the ground, by height and elevation of the sun;
 * per unit solar irradiance. Between the nodes the logarithm of the mean radiance is linear, since it falls exponentially
 * after sunset, and so are the ratios of the other moments to it.
 */
final class LightField {
    static final int HEIGHTS = 20;
    /** Elevations of the sun for which light is computed; {@link #refined} has more. */
    static final int SUNS = 40;

    private static final int REFINEMENT = 4;
    private static final double LOWEST_SUN_DEGREES = -30;
    /** Elevation at which nodes are densest, and how much denser than far from it. */
    private static final double STRETCH_DEGREES = 6;

    private static final double DARK = 1e-40;

    private static final double FIRST = warped(LOWEST_SUN_DEGREES);
    private static final double LAST = warped(90);

    private final int degree;
    private final int moments;
    private final int suns;
    /** For each node and wavelength the logarithm of the first moment, then the ratios of the others. */
    private final float[] values;

    /** For each node and wavelength, its logarithm. */
    private final float[] groundIrradiance;

    LightField(int degree) {
        this(degree, SUNS);
    }

    private LightField(int degree, int suns) {
        this.degree = degree;
        this.suns = suns;
        moments = DirectionMoments.count(degree);
        values = new float[HEIGHTS * suns * Air.CHANNELS * moments];
        groundIrradiance = new float[suns * Air.CHANNELS];
    }

    /** Returns this field with more nodes of the sun's elevation, on cubics through its own (Catmull and Rom 1974). */
    LightField refined() {
        LightField fine = new LightField(degree, (suns - 1) * REFINEMENT + 1);
        int row = Air.CHANNELS * moments;
        for (int height = 0; height < HEIGHTS; height++) {
            refine(values, height * suns, fine.values, height * fine.suns, row);
        }
        refine(groundIrradiance, 0, fine.groundIrradiance, 0, Air.CHANNELS);
        return fine;
    }

    private void refine(float[] from, int first, float[] to, int firstTo, int row) {
        for (int i = 0; i <= (suns - 1) * REFINEMENT; i++) {
            int node = Math.min(suns - 2, i / REFINEMENT);
            double t = i / (double) REFINEMENT - node;
            int before = first + Math.max(0, node - 1);
            int after = first + Math.min(suns - 1, node + 2);
            for (int k = 0; k < row; k++) {
                double b = from[(first + node) * row + k];
                double c = from[(first + node + 1) * row + k];
                double slopeB = (c - from[before * row + k]) / (first + node + 1 - before);
                double slopeC = (from[after * row + k] - b) / (after - first - node);
                to[(firstTo + i) * row + k] = (float) hermite(t, b, c, slopeB, slopeC);
            }
        }
    }

    private static double hermite(double t, double from, double to, double slopeFrom, double slopeTo) {
        double s = 1 - t;
        return s * s * (1 + 2 * t) * from + t * t * (1 + 2 * s) * to + s * t * (s * slopeFrom - t * slopeTo);
    }

    /** Returns all numbers, to read or to write them. */
    float[][] arrays() {
        return new float[][] {values, groundIrradiance};
    }

    int degree() {
        return degree;
    }

    private static double warped(double degrees) {
        double x = degrees / STRETCH_DEGREES;
        return Math.signum(x) * Math.log1p(Math.abs(x));
    }

    /** Returns the height of a node, metres. */
    static double heightMetres(int j) {
        double fraction = j / (HEIGHTS - 1.0);
        return Air.TOP_METRES * fraction * fraction;
    }

    /** Returns the sine of the sun's elevation at a node. */
    static double sunCosine(int i) {
        double w = FIRST + (LAST - FIRST) * i / (SUNS - 1);
        return Math.sin(Math.toRadians(Math.signum(w) * Math.expm1(Math.abs(w)) * STRETCH_DEGREES));
    }

    private int start(int height, int sun, int channel) {
        return ((height * suns + sun) * Air.CHANNELS + channel) * moments;
    }

    /** Sets the moments at a node. */
    void set(int height, int sun, int channel, double[] of) {
        int at = start(height, sun, channel);
        double first = Math.max(DARK, of[0]);
        values[at] = (float) Math.log(first);
        for (int k = 1; k < moments; k++) {
            values[at + k] = (float) (of[k] / first);
        }
    }

    void setGroundIrradiance(int sun, int channel, double irradiance) {
        groundIrradiance[sun * Air.CHANNELS + channel] = (float) Math.log(Math.max(DARK, irradiance));
    }

    private double sunIndex(double sunCosine) {
        double degrees = Math.toDegrees(Math.asin(Math.max(-1, Math.min(1, sunCosine))));
        double w = (warped(degrees) - FIRST) / (LAST - FIRST) * (suns - 1);
        return Math.max(0, Math.min(suns - 1, w));
    }

    /** Puts the irradiance of the ground by scattered light where the sun has an elevation. */
    void putGroundIrradiance(double sunCosine, double[] irradiance) {
        double x = sunIndex(sunCosine);
        int i = Math.min(suns - 2, (int) x);
        for (int c = 0; c < Air.CHANNELS; c++) {
            double low = groundIrradiance[i * Air.CHANNELS + c];
            double high = groundIrradiance[(i + 1) * Air.CHANNELS + c];
            irradiance[c] = Math.exp(low + (x - i) * (high - low));
        }
    }

    /**
     * Puts Σ weight × moment, for each wavelength.
     *
     * @param weights wavelength by wavelength, one for each moment of the first degrees
     * @param count of the moments of these degrees
     */
    void putSum(double heightMetres, double sunCosine, double[] weights, int count, double[] sums) {
        double y = Math.sqrt(Math.max(0, Math.min(1, heightMetres / Air.TOP_METRES))) * (HEIGHTS - 1);
        double x = sunIndex(sunCosine);
        int i = Math.min(suns - 2, (int) x);
        int j = Math.min(HEIGHTS - 2, (int) y);
        double u = x - i;
        double v = y - j;
        for (int c = 0; c < Air.CHANNELS; c++) {
            int low = start(j, i, c);
            int lowNext = start(j, i + 1, c);
            int high = start(j + 1, i, c);
            int highNext = start(j + 1, i + 1, c);
            double ofLow = 0;
            double ofLowNext = 0;
            double ofHigh = 0;
            double ofHighNext = 0;
            for (int k = 1; k < count; k++) {
                double weight = weights[c * count + k];
                ofLow += weight * values[low + k];
                ofLowNext += weight * values[lowNext + k];
                ofHigh += weight * values[high + k];
                ofHighNext += weight * values[highNext + k];
            }
            double logarithm = (1 - v) * ((1 - u) * values[low] + u * values[lowNext])
                    + v * ((1 - u) * values[high] + u * values[highNext]);
            double ratio = weights[c * count]
                    + (1 - v) * ((1 - u) * ofLow + u * ofLowNext)
                    + v * ((1 - u) * ofHigh + u * ofHighNext);
            sums[c] = Math.exp(logarithm) * ratio;
        }
    }
}
