package nephele.engine.level.appearance;

import java.util.List;
import nephele.engine.asset.AssetException;
import nephele.engine.level.Cloud;
import nephele.engine.level.Environment;
import nephele.engine.math.Vec3;

/**
 * What the clouds of an environment demand before any of them is sampled: into how many cells they are divided, and estimates of
 * memory and time. All clouds share {@value #MOST_CELLS} cells; where they would need more, each has coarser ones.
 *
 * @param clouds their number
 * @param layers those that are layers
 * @param seeds tables of noise
 * @param cells of all clouds at a time
 * @param fraction 0–1, cells that the clouds have of those that they would have alone
 * @param samples times of which cells are kept
 */
public record CloudDemand(int clouds, int layers, int seeds, long cells, double fraction, int samples) {
    /** Cells of all clouds, unless they are too many to be divided more coarsely. */
    public static final long MOST_CELLS = 8_000_000;

    /** Boxes of a layer, each wider than the one before. */
    public static final int LAYER_BOXES = 6;

    /** Cells of a layer's box along x and z. */
    public static final int LAYER_ACROSS = 64;

    /** Cells along the longest edge of a finite cloud. */
    private static final int LONGEST = 96;

    private static final int LEAST_LONGEST = 12;
    private static final double ROW_METRES = 60;
    private static final int FEWEST_ROWS = 20;
    private static final int MOST_ROWS = 48;
    private static final int LEAST_ROWS = 6;

    /** Times of which the cells of moving clouds are kept. */
    private static final int KEPT = 3;

    /** Density, distance and a share of the light. */
    private static final double BYTES_PER_CELL = 8;

    private static final double BYTES_PER_SEED = 1e6;
    /** What else a picture needs. */
    private static final double OTHER_BYTES = 100e6;

    /** Measured on one core of a machine of 2024. */
    private static final double SECONDS_PER_CELL = 0.8e-6;

    private static final double SECONDS_PER_SEED = 0.15;
    private static final double SECONDS_PER_PAIR_OF_LAYERS = 3e-3;
    private static final double SECONDS_PER_CLOUD = 0.01;

    /** Returns the demand of an environment's clouds, those of its weather included. */
    public static CloudDemand of(Environment environment) {
        return of(WeatherClouds.all(environment));
    }

    /** Returns the demand of clouds. */
    public static CloudDemand of(List<Cloud> clouds) {
        long alone = clouds.stream().mapToLong(cloud -> cells(cloud, 1)).sum();
        double fraction = Math.min(1, MOST_CELLS / Math.max(1.0, alone));
        boolean isStill = clouds.stream().allMatch(cloud -> cloud.motion().equals(Cloud.Motion.STILL));
        return new CloudDemand(
                clouds.size(),
                (int) clouds.stream().filter(CloudDemand::isLayer).count(),
                (int) clouds.stream()
                        .filter(cloud -> cloud.density() instanceof Cloud.Density.Noise)
                        .map(cloud -> ((Cloud.Density.Noise) cloud.density()).seed())
                        .distinct()
                        .count(),
                clouds.stream().mapToLong(cloud -> cells(cloud, fraction)).sum(),
                fraction,
                isStill ? 1 : KEPT);
    }

    private static boolean isLayer(Cloud cloud) {
        return cloud.extent() instanceof Cloud.Extent.Layer;
    }

    private static long cells(Cloud cloud, double fraction) {
        if (cloud.extent() instanceof Cloud.Extent.Volume volume) {
            int longest = longest(fraction);
            Vec3 size = volume.size();
            double cell = Math.max(size.x(), Math.max(size.y(), size.z())) / longest;
            return along(size.x(), cell) * along(size.y(), cell) * along(size.z(), cell);
        }
        double height = ((Cloud.Extent.Layer) cloud.extent()).thicknessMetres();
        return (long) LAYER_BOXES * LAYER_ACROSS * LAYER_ACROSS * rows(height, fraction);
    }

    private static long along(double metres, double cell) {
        return Math.max(1, Math.round(metres / cell));
    }

    private static int longest(double fraction) {
        return (int) Math.max(LEAST_LONGEST, Math.floor(LONGEST * Math.cbrt(fraction)));
    }

    private static int rows(double heightMetres, double fraction) {
        double alone = Math.max(FEWEST_ROWS, Math.min(MOST_ROWS, Math.round(heightMetres / ROW_METRES)));
        return (int) Math.max(LEAST_ROWS, Math.floor(alone * fraction));
    }

    /** Returns the cells along the longest edge of a finite cloud. */
    public int longest() {
        return longest(fraction);
    }

    /** Returns the rows of a layer's cells. */
    public int rows(double heightMetres) {
        return rows(heightMetres, fraction);
    }

    /** Returns the memory that Java needs for them and for what else a picture needs, estimated. */
    public double bytes() {
        return bytesOfTables() + cells * BYTES_PER_CELL * samples;
    }

    private double bytesOfTables() {
        return OTHER_BYTES + seeds * BYTES_PER_SEED;
    }

    /**
     * Asks for the memory of all before any is taken.
     *
     * @param most bytes that Java may take
     * @throws AssetException if they do not suffice
     */
    public void requireMemory(long most) {
        require(bytes(), most);
    }

    /** Does the same for the tables of noise alone, without which no picture is made, not even a traced one. */
    public void requireMemoryOfTables(long most) {
        require(bytesOfTables(), most);
    }

    private void require(double bytes, long most) {
        if (bytes > most) {
            throw new AssetException(
                    "environment.clouds",
                    clouds + " clouds need " + words() + ", more than the " + Math.round(most / 1e6)
                            + " MB that Java may take",
                    "use fewer layers and fewer seeds of noise, or give Java more, for example `java -Xmx4g -jar …`");
        }
    }

    /** Returns the processor's time until they are drawn, estimated. */
    public double seconds() {
        return cells * SECONDS_PER_CELL
                + seeds * SECONDS_PER_SEED
                + (double) layers * layers * SECONDS_PER_PAIR_OF_LAYERS
                + clouds * SECONDS_PER_CLOUD;
    }

    /** Returns the estimates in words. */
    public String words() {
        return "some " + Math.round(seconds()) + " s of a processor's time and " + Math.round(bytes() / 1e6)
                + " MB of memory";
    }
}
