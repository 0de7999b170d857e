package nephele.engine.atmosphere;

import java.util.function.Function;
import java.util.stream.IntStream;
import nephele.engine.math.Vec3;
import nephele.engine.work.SwingThread;

/**
 * The light that the air between an eye and a surface adds and lets pass, tabulated by azimuth from the sun, elevation and
 * distance (as in S. Hillaire, "A Scalable and Production Ready Sky and Atmosphere Rendering Technique", 2020, section
 * 5.4, but around the eye instead of in the view's frustum, so that all views at a height share a table). Twin of {@code
 * include/air.glsl}. Per unit solar irradiance. Immutable.
 *
 * <p>With x = s / (s + 100 km) for the distance s, the slices are equally spaced in √x up to {@value
 * #FARTHEST_METRES} m; paths that are longer add no more light. The square root of radiance / x is stored: it changes
 * little from slice to slice. The fourth number is the extinction at 680 nm, averaged along the path; that at the other
 * wavelengths has more of the molecules, whose mean density follows from the heights of both ends. The ozone absorbs 680
 * nm less than 550 nm and more than 440 nm; the differences are neglected.
 */
public final class AerialTable {
    public static final int AZIMUTHS = 24;
    /** Densest at the horizon, which is the middle one. */
    public static final int ROWS = 65;

    public static final int SLICES = 24;
    /** Distance at which half of the slices are nearer in terms of x. */
    public static final double MIDDLE_METRES = 100_000;

    /** Rise of a segment within which its density does not change. */
    private static final double LEVEL_METRES = 10;

    /** Factor that keeps the extinction in the range of half floats. */
    private static final double EXTINCTION_SCALE = 1e4;

    private static final int NUMBERS = 4;
    private static final int CHANNELS = Air.CHANNELS;
    private static final double FARTHEST_METRES = 200_000;

    private final double heightMetres;
    private final double sunSine;
    private final double horizon;
    private final float[] values = new float[SLICES * ROWS * AZIMUTHS * NUMBERS];

    /**
     * Computes the table of all light on all processors.
     *
     * @param heightMetres of the eye
     * @param sunSine of the sun's elevation
     */
    public AerialTable(AirTables tables, double heightMetres, double sunSine) {
        this(tables, AerialTable::allScattering, heightMetres, sunSine);
    }

    /** Computes the table of the light that the air scatters once, which clouds can shade. */
    public static AerialTable ofFirstScattering(AirTables tables, double heightMetres, double sunSine) {
        return new AerialTable(tables, SingleScattering::withPhases, heightMetres, sunSine);
    }

    /** Returns all sunlight that the air scatters into a ray, for one thread. */
    private static AirSource allScattering(AirTables tables) {
        AirSource once = SingleScattering.withPhases(tables);
        AirSource more = new RepeatedScattering(tables.air(), tables.field(), tables.mieMoments());
        double[] single = new double[CHANNELS];
        return (ray, radiancePerMetre) -> {
            more.put(ray, radiancePerMetre);
            once.put(ray, single);
            for (int c = 0; c < CHANNELS; c++) {
                radiancePerMetre[c] += single[c];
            }
        };
    }

    private AerialTable(AirTables tables, Function<AirTables, AirSource> source, double heightMetres, double sunSine) {
        SwingThread.refuse("the table of air");
        this.sunSine = sunSine;
        this.heightMetres = Math.max(0, Math.min(Air.TOP_METRES, heightMetres));
        horizon = SkyTable.horizon(this.heightMetres);
        double[] distances =
                IntStream.range(1, SLICES).mapToDouble(AerialTable::metres).toArray();
        IntStream.range(0, ROWS).parallel().forEach(row -> fillRow(tables, source.apply(tables), row, distances));
    }

    private static double metres(int slice) {
        double root = slice / (SLICES - 1.0);
        double x = root * root * x(FARTHEST_METRES);
        return MIDDLE_METRES * x / (1 - x);
    }

    private static double x(double metres) {
        return metres / (metres + MIDDLE_METRES);
    }

    private void fillRow(AirTables tables, AirSource source, int row, double[] distances) {
        AirIntegral integral = new AirIntegral(tables.air(), AirIntegral.SHORT);
        AirRay ray = new AirRay(tables.air().shadowEdgeRadians(), distances.length);
        double[] light = new double[2 * CHANNELS * distances.length];
        double sine = sine(row);
        double sines = Math.sqrt((1 - sine * sine) * Math.max(0, 1 - sunSine * sunSine));
        for (int column = 0; column < AZIMUTHS; column++) {
            double half = column / (AZIMUTHS - 1.0);
            double between = sine * sunSine + sines * (1 - 2 * half * half);
            ray.setSegment(heightMetres, sine, sunSine, Math.max(-1, Math.min(1, between)), distances);
            integral.putParts(ray, source, distances, light);
            for (int slice = 1; slice < SLICES; slice++) {
                put(slice, row, column, light);
            }
            // At no distance, where x is 0 too, the values of the first slice hold.
            System.arraycopy(values, index(1, row, column), values, index(0, row, column), NUMBERS);
        }
    }

    private void put(int slice, int row, int column, double[] light) {
        double metres = metres(slice);
        double x = x(metres);
        int at = index(slice, row, column);
        int from = 2 * CHANNELS * (slice - 1);
        for (int c = 0; c < CHANNELS; c++) {
            values[at + c] = (float) Math.sqrt(Math.max(0, light[from + c]) / x);
        }
        double depth = -Math.log(Math.max(1e-30, light[from + CHANNELS]));
        values[at + CHANNELS] = (float) (EXTINCTION_SCALE * depth / metres);
    }

    /** Returns the sine of a row's elevation. */
    private double sine(int row) {
        double fraction = 2.0 * row / (ROWS - 1) - 1;
        double t = horizon + fraction * fraction * (fraction < 0 ? -1 - horizon : 1 - horizon);
        return Math.max(-1, Math.min(1, 2 * t / (1 + t * t)));
    }

    private double row(double sine) {
        double t = sine / (1 + Math.sqrt(Math.max(0, 1 - sine * sine)));
        double fraction =
                t < horizon ? -Math.sqrt((horizon - t) / (1 + horizon)) : Math.sqrt((t - horizon) / (1 - horizon));
        return (fraction + 1) / 2 * (ROWS - 1);
    }

    private static int index(int slice, int row, int column) {
        return ((slice * ROWS + row) * AZIMUTHS + column) * NUMBERS;
    }

    /** Returns the texels of a texture of RGBA, slice by slice. */
    public float[] texels() {
        return values.clone();
    }

    /** Returns the density of the molecules, relative to that at the ground, averaged along a segment. */
    private double meanDensity(double sine, double metres) {
        double end =
                heightMetres + metres * sine + metres * metres * (1 - sine * sine) / (2 * Air.PLANET_RADIUS_METRES);
        double rise = end - heightMetres;
        return Math.abs(rise) < LEVEL_METRES ? density(heightMetres) : (column(end) - column(heightMetres)) / rise;
    }

    /** Returns the density of the molecules, relative to that at the ground. */
    public static double density(double heightMetres) {
        return Math.exp(-Math.max(0, heightMetres) / Air.RAYLEIGH_HEIGHT_METRES);
    }

    /** Returns the molecules between height 0 and another height, relative to the density at the ground, metres. */
    public static double column(double heightMetres) {
        double scale = Air.RAYLEIGH_HEIGHT_METRES;
        return heightMetres < 0 ? heightMetres : scale * (1 - Math.exp(-heightMetres / scale));
    }

    /**
     * Returns what the air between the eye and a point does to light.
     *
     * @param direction from the eye, unit
     * @param towardsSun unit, of the table's elevation
     */
    public AirLight along(Vec3 direction, Vec3 towardsSun, double metres) {
        double level = Math.hypot(direction.x(), direction.z()) * Math.hypot(towardsSun.x(), towardsSun.z());
        double azimuth = (direction.x() * towardsSun.x() + direction.z() * towardsSun.z()) / Math.max(1e-12, level);
        double x = Math.min(x(metres), x(FARTHEST_METRES));
        double column = Math.sqrt(Math.max(0, (1 - azimuth) / 2)) * (AZIMUTHS - 1);
        double[] four = interpolated(
                Math.sqrt(x / x(FARTHEST_METRES)) * (SLICES - 1), row(direction.y()), Math.min(AZIMUTHS - 1, column));
        double density = meanDensity(direction.y(), metres);
        double[] transmittance = new double[CHANNELS];
        for (int c = 0; c < CHANNELS; c++) {
            double besides = (Air.rayleighPerMetre(c) - Air.rayleighPerMetre(0)) * density;
            transmittance[c] = Math.exp(-metres * Math.max(0, four[CHANNELS] / EXTINCTION_SCALE + besides));
        }
        return new AirLight(
                new Vec3(four[0] * four[0] * x, four[1] * four[1] * x, four[2] * four[2] * x),
                new Vec3(transmittance[0], transmittance[1], transmittance[2]));
    }

    private double[] interpolated(double z, double y, double x) {
        int slice = Math.min(SLICES - 2, (int) z);
        int row = Math.min(ROWS - 2, (int) y);
        int column = Math.min(AZIMUTHS - 2, (int) x);
        double[] four = new double[NUMBERS];
        for (int corner = 0; corner < 8; corner++) {
            int right = corner & 1;
            int up = corner >> 1 & 1;
            int far = corner >> 2;
            double weight = weight(x - column, right) * weight(y - row, up) * weight(z - slice, far);
            int at = index(slice + far, row + up, column + right);
            for (int k = 0; k < NUMBERS; k++) {
                four[k] += weight * values[at + k];
            }
        }
        return four;
    }

    private static double weight(double between, int side) {
        return side == 1 ? between : 1 - between;
    }
}
