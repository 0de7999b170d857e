package nephele.engine.atmosphere;

import java.nio.FloatBuffer;
import java.util.stream.IntStream;
import nephele.engine.math.Vec3;
import nephele.engine.work.SwingThread;

/**
 * The light of a clear sky around an eye, tabulated by elevation and azimuth from the sun: what a shader or the oracle
 * looks up. The rows are densest at the horizon, as in S. Hillaire, "A Scalable and Production Ready Sky and Atmosphere
 * Rendering Technique", 2020, section 5.3, but sky and ground have rows of their own and nothing is interpolated across
 * the horizon. Light scattered once by aerosols is without its phase function, which is evaluated for each direction. Per
 * unit solar irradiance. The square roots are stored and interpolated, since the light falls exponentially. Immutable.
 */
public final class SkyTable {
    public static final int SKY_ROWS = 152;
    public static final int GROUND_ROWS = 64;
    public static final int AZIMUTHS = 88;
    /** Tangent of half the elevation up to which half of the sky's rows are. */
    private static final double BAND = Math.tan(Math.toRadians(4));
    /** From above this height most of the sky's rows lie in the limb, which may be far brighter than the rest. */
    private static final double LIMB_METRES = 40_000;

    private static final double LEAST = 5e-8;
    public static final int ROWS = SKY_ROWS + GROUND_ROWS;
    /** Light scattered once by aerosols, and all other light. */
    public static final int PARTS = 2;

    private static final int CHANNELS = Air.CHANNELS;

    /** Light that is scattered more than once changes slowly with azimuth: it is integrated at every third one. */
    private static final int MORE_STEP = 3;

    private static final int MORE_NODES = (AZIMUTHS - 1) / MORE_STEP + 1;

    private final Air air;
    /** Elevations e are measured by tan(e / 2). */
    private final double horizon;

    private final double bandEnd;
    private final double bandShare;
    /** Part by part, row by row. */
    private final float[] values = new float[PARTS * ROWS * AZIMUTHS * CHANNELS];

    /**
     * Computes the table on all processors.
     *
     * @param heightMetres of the eye
     * @param sunCosine between the zenith and the sun
     */
    public SkyTable(AirTables tables, double heightMetres, double sunCosine) {
        SwingThread.refuse("the table of a sky");
        air = tables.air();
        double height = Math.max(0, Math.min(Air.TOP_METRES, heightMetres));
        horizon = horizon(height);
        bandEnd = bandEnd(height);
        bandShare = bandShare(height);
        IntStream.range(0, ROWS).parallel().forEach(row -> fillRow(tables, height, sunCosine, row));
    }

    private void fillRow(AirTables tables, double height, double sunCosine, int row) {
        ClearSky sky = new ClearSky(tables, sunCosine < 0 ? AirIntegral.FINE : AirIntegral.COARSE, AirIntegral.COARSE);
        AirRay ray = new AirRay(tables.air().shadowEdgeRadians(), 0);
        double[] parts = new double[ClearSky.PARTS * CHANNELS];
        double[] more = new double[CHANNELS];
        double t = elevation(row);
        double sine = 2 * t / (1 + t * t);
        double sines = (1 - t * t) / (1 + t * t) * Math.sqrt(Math.max(0, 1 - sunCosine * sunCosine));
        double[] nodes = new double[MORE_NODES * CHANNELS];
        for (int node = 0; node < MORE_NODES; node++) {
            ray.set(height, sine, sunCosine, between(sine * sunCosine, sines, node * MORE_STEP));
            sky.putMore(ray, more);
            for (int c = 0; c < CHANNELS; c++) {
                nodes[node * CHANNELS + c] = Math.sqrt(Math.max(0, more[c]));
            }
        }
        for (int column = 0; column < AZIMUTHS; column++) {
            double between = between(sine * sunCosine, sines, column);
            ray.set(height, sine, sunCosine, between);
            sky.putOnce(ray, parts);
            putMore(nodes, column, more);
            double rayleigh = Air.rayleighPhase(between);
            for (int c = 0; c < CHANNELS; c++) {
                put(0, row, column, c, parts[CHANNELS + c]);
                put(1, row, column, c, rayleigh * parts[c] + parts[2 * CHANNELS + c] + more[c]);
            }
        }
    }

    private static double between(double cosines, double sines, int column) {
        double half = column / (AZIMUTHS - 1.0);
        return Math.max(-1, Math.min(1, cosines + sines * (1 - 2 * half * half)));
    }

    /** Puts the light of a column, interpolated between the square roots at nodes. */
    private static void putMore(double[] nodes, int column, double[] light) {
        double[] weights = new double[4];
        int cell = CubicWeights.cell(column / (double) MORE_STEP, MORE_NODES);
        CubicWeights.put(column / (double) MORE_STEP - cell, cell, MORE_NODES, weights);
        for (int c = 0; c < CHANNELS; c++) {
            double root = 0;
            for (int k = 0; k < weights.length; k++) {
                int node = Math.max(0, Math.min(MORE_NODES - 1, cell - 1 + k));
                root += weights[k] * nodes[node * CHANNELS + c];
            }
            light[c] = root * root;
        }
    }

    private void put(int part, int row, int column, int channel, double light) {
        values[index(part, row, column) + channel] = (float) Math.sqrt(Math.max(0, light));
    }

    /** Returns tan(e / 2) of the elevation e of a row. */
    private double elevation(int row) {
        // The first rows are just above and below the horizon.
        if (row >= SKY_ROWS) {
            double fraction = (row - SKY_ROWS) / (GROUND_ROWS - 1.0);
            return Math.max(-1, horizon - Math.max(LEAST, (horizon + 1) * Math.pow(fraction, 4)));
        }
        double y = row / (SKY_ROWS - 1.0);
        double band = bandEnd - horizon;
        double inBand = y / bandShare;
        double besides = (y - bandShare) / (1 - bandShare);
        double above = inBand <= 1 ? band * inBand * inBand : band + (1 - bandEnd) * besides * besides;
        return Math.min(1, horizon + Math.max(LEAST, above));
    }

    /** Returns the row of an elevation, which lies between the rows of the sky or those of the ground. */
    private double row(double elevation) {
        double above = elevation - horizon;
        if (above < 0) {
            return SKY_ROWS + Math.pow(Math.min(1, -above / (horizon + 1)), 0.25) * (GROUND_ROWS - 1);
        }
        double band = bandEnd - horizon;
        double besides = Math.sqrt(Math.max(0, Math.min(1, (above - band) / (1 - bandEnd))));
        double y = above <= band ? bandShare * Math.sqrt(above / band) : bandShare + (1 - bandShare) * besides;
        return y * (SKY_ROWS - 1);
    }

    private static int index(int layer, int row, int column) {
        return ((layer * ROWS + row) * AZIMUTHS + column) * CHANNELS;
    }

    /** Returns the elevation of the horizon as seen from a height, at most 0. */
    public static double horizonRadians(double heightMetres) {
        double height = Math.max(0, heightMetres);
        double square = height * (2 * Air.PLANET_RADIUS_METRES + height);
        return -Math.atan2(Math.sqrt(square), Air.PLANET_RADIUS_METRES);
    }

    /** Returns tan(e / 2) of the elevation e of the horizon as seen from a height. */
    public static double horizon(double heightMetres) {
        return Math.tan(horizonRadians(heightMetres) / 2);
    }

    /** Returns tan(e / 2) of the elevation e at which the rows begin to be dense a second time. */
    public static double bandEnd(double heightMetres) {
        return heightMetres < LIMB_METRES ? BAND : 0;
    }

    /** Returns the fraction of the sky's rows up to {@link #bandEnd}. */
    public static double bandShare(double heightMetres) {
        return heightMetres < LIMB_METRES ? 0.5 : 0.85;
    }

    /** Returns the square roots of all parts for a texture of RGBA, row by row, those of the sky first. */
    public float[] texels() {
        int count = PARTS * ROWS * AZIMUTHS;
        FloatBuffer texels = FloatBuffer.allocate(4 * count);
        for (int i = 0; i < count; i++) {
            texels.put(values, i * CHANNELS, CHANNELS).put(1);
        }
        return texels.array();
    }

    /**
     * Returns the radiance without the sun's disc, per unit solar irradiance, 1/sr.
     *
     * @param direction unit
     * @param towardsSun unit, of the table's elevation
     */
    public Vec3 radiance(Vec3 direction, Vec3 towardsSun) {
        double level = Math.hypot(direction.x(), direction.z());
        double levels = Math.max(1e-12, level * Math.hypot(towardsSun.x(), towardsSun.z()));
        double azimuth = (direction.x() * towardsSun.x() + direction.z() * towardsSun.z()) / levels;
        double between = Math.max(-1, Math.min(1, direction.dot(towardsSun)));
        double y = row(direction.y() / (1 + level));
        double x = Math.sqrt(Math.max(0, Math.min(1, (1 - azimuth) / 2))) * (AZIMUTHS - 1);
        double mie = air.miePhase(between);
        double[] sum = new double[CHANNELS];
        for (int c = 0; c < CHANNELS; c++) {
            sum[c] = mie * value(0, y, x, c) + value(1, y, x, c);
        }
        return new Vec3(sum[0], sum[1], sum[2]);
    }

    private double value(int layer, double y, double x, int channel) {
        int row = y < SKY_ROWS ? Math.min(SKY_ROWS - 2, (int) y) : Math.min(ROWS - 2, (int) y);
        int column = Math.min(AZIMUTHS - 2, (int) x);
        double v = y - row;
        double u = x - column;
        int at = index(layer, row, column) + channel;
        int next = index(layer, row + 1, column) + channel;
        double low = values[at] + u * (values[at + CHANNELS] - values[at]);
        double high = values[next] + u * (values[next + CHANNELS] - values[next]);
        double root = low + v * (high - low);
        return root * root;
    }
}
