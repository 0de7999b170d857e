package nephele.engine.atmosphere;

import java.nio.FloatBuffer;
import java.util.stream.IntStream;
import nephele.engine.math.Vec3;

/**
 * The light of a clear sky around an eye, tabulated by elevation and azimuth from the sun: what a shader or the oracle
 * looks up. The rows are densest at the horizon, as in S. Hillaire, "A Scalable and Production Ready Sky and Atmosphere
 * Rendering Technique", 2020, section 5.3, but sky and ground have rows of their own and nothing is interpolated across
 * the horizon. Light scattered once is without its phase functions, which are evaluated for each direction. Per unit
 * solar irradiance. The square roots are stored and interpolated, since the light falls exponentially. Immutable.
 */
public final class SkyTable {
    public static final int SKY_ROWS = 96;
    public static final int GROUND_ROWS = 40;
    public static final int AZIMUTHS = 48;
    /** Elevation up to which half of the rows are. */
    private static final double BAND_RADIANS = Math.toRadians(8);

    private static final double LEAST_RADIANS = 1e-7;
    public static final int ROWS = SKY_ROWS + GROUND_ROWS;
    /** Light scattered once by molecules, once by aerosols, and all other light. */
    public static final int PARTS = ClearSky.PARTS;

    private static final int CHANNELS = Air.CHANNELS;

    private final Air air;
    private final double horizonRadians;
    /** Part by part, row by row. */
    private final float[] values = new float[PARTS * ROWS * AZIMUTHS * CHANNELS];

    /**
     * Computes the table on all processors.
     *
     * @param heightMetres of the eye
     * @param sunCosine between the zenith and the sun
     */
    public SkyTable(AirTables tables, double heightMetres, double sunCosine) {
        air = tables.air();
        double height = Math.max(0, Math.min(Air.TOP_METRES, heightMetres));
        horizonRadians = horizonRadians(height);
        IntStream.range(0, ROWS).parallel().forEach(row -> fillRow(tables, height, sunCosine, row));
    }

    private void fillRow(AirTables tables, double height, double sunCosine, int row) {
        ClearSky sky = new ClearSky(tables, sunCosine < 0 ? AirIntegral.FINE : AirIntegral.COARSE);
        AirRay ray = new AirRay();
        double[] parts = new double[PARTS * CHANNELS];
        double elevation = elevationRadians(row);
        double sines = Math.cos(elevation) * Math.sqrt(Math.max(0, 1 - sunCosine * sunCosine));
        for (int column = 0; column < AZIMUTHS; column++) {
            double azimuth = Math.PI * column / (AZIMUTHS - 1);
            double between = Math.sin(elevation) * sunCosine + sines * Math.cos(azimuth);
            ray.set(height, Math.sin(elevation), sunCosine, between);
            sky.put(ray, parts);
            for (int k = 0; k < parts.length; k++) {
                values[index(k / CHANNELS, row, column) + k % CHANNELS] = (float) Math.sqrt(Math.max(0, parts[k]));
            }
        }
    }

    private double elevationRadians(int row) {
        // The first rows are just above and below the horizon.
        if (row >= SKY_ROWS) {
            double share = (row - SKY_ROWS) / (GROUND_ROWS - 1.0);
            return horizonRadians - Math.max(LEAST_RADIANS, groundRadians() * Math.pow(share, 4));
        }
        double twice = 2 * row / (SKY_ROWS - 1.0);
        double band = BAND_RADIANS - horizonRadians;
        double above =
                twice <= 1 ? band * twice * twice : band + (Math.PI / 2 - BAND_RADIANS) * (twice - 1) * (twice - 1);
        return horizonRadians + Math.max(LEAST_RADIANS, above);
    }

    /** Returns the row of an elevation, which lies between the rows of the sky or those of the ground. */
    private double row(double elevation) {
        double above = elevation - horizonRadians;
        if (above < 0) {
            return SKY_ROWS + Math.pow(Math.min(1, -above / groundRadians()), 0.25) * (GROUND_ROWS - 1);
        }
        double band = BAND_RADIANS - horizonRadians;
        double twice = above <= band
                ? Math.sqrt(above / band)
                : 1 + Math.sqrt(Math.min(1, (above - band) / (Math.PI / 2 - BAND_RADIANS)));
        return twice / 2 * (SKY_ROWS - 1);
    }

    private double groundRadians() {
        return horizonRadians + Math.PI / 2;
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

    /** Returns the elevation of the horizon, at most 0. */
    public double horizonRadians() {
        return horizonRadians;
    }

    /** Puts the square roots of a part for a texture of RGBA, row by row, those of the sky first. */
    public void putTexels(int part, FloatBuffer texels) {
        int first = index(part, 0, 0);
        for (int i = 0; i < ROWS * AZIMUTHS; i++) {
            texels.put(values, first + i * CHANNELS, CHANNELS).put(1);
        }
    }

    /**
     * Returns the radiance without the sun's disc, per unit solar irradiance, 1/sr.
     *
     * @param direction unit
     * @param towardsSun unit, of the table's elevation
     */
    public Vec3 radiance(Vec3 direction, Vec3 towardsSun) {
        double level = Math.hypot(direction.x(), direction.z());
        double elevation = Math.atan2(direction.y(), level);
        double along = direction.x() * towardsSun.x() + direction.z() * towardsSun.z();
        double across = direction.x() * towardsSun.z() - direction.z() * towardsSun.x();
        double azimuth = Math.abs(Math.atan2(across, along));
        double between = Math.max(-1, Math.min(1, direction.dot(towardsSun)));
        double y = row(elevation);
        double x = azimuth / Math.PI * (AZIMUTHS - 1);
        double rayleigh = Air.rayleighPhase(between);
        double mie = air.miePhase(between);
        double[] sum = new double[CHANNELS];
        for (int c = 0; c < CHANNELS; c++) {
            sum[c] = rayleigh * value(0, y, x, c) + mie * value(1, y, x, c) + value(2, y, x, c);
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
