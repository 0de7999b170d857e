package nephele.workshop.art;

import java.awt.image.BufferedImage;
import java.util.List;
import java.util.function.DoubleBinaryOperator;
import java.util.stream.IntStream;
import nephele.engine.math.SeededNoise;
import nephele.workshop.art.picture.PictureRecipe;

/**
 * The ground of the level "Standing stones" and where plants grow on it: meadows on both sides of a gorge, a hill with a
 * cliff, a rock with steep sides beside it, and mountains around. Cliffs are steeper than a player can walk; the gorge
 * has one ramp, to the south.
 */
public final class StonesMap {
    public static final String FILE = "terrain/stones.png";

    /** Samples along a side, half a metre apart. */
    public static final int SIDE = 513;

    /** The height of full scale. */
    public static final double MOST_METRES = 80;

    private static final int SEED = 6;
    private static final double HALF_METRES = 128;

    private static final double MEADOW = 16;
    private static final double HILL_TOP = 40;
    private static final double ROCK_TOP = 38;
    private static final double GORGE_FLOOR = 2;

    private static final int GROWTH_SIDE = 257;
    private static final SeededNoise GROWTH_NOISE = new SeededNoise(61);

    /** Where plants grow: pictures that are as bright as plants are dense. */
    public static final List<PictureRecipe> GROWTH = List.of(
            recipe("meadow", (x, z) -> clear(x, z, 1) * (0.25 + 0.75 * patches(x, z, 14, 0.42))),
            recipe("flowers", (x, z) -> clear(x, z, 1.2) * patches(x, z, 17, 0.62)),
            recipe("forest", (x, z) -> clear(x, z, 2) * Math.max(patches(x, z, 34, 0.52), rim(x, z))));

    /** A round place to keep free. */
    private record Place(double x, double z, double radius) {}

    /** Start, gate, temple, basin, top of the hill, goal; then the paths between them. */
    private static final List<Place> PLACES = List.of(
            new Place(0, 60, 8.5),
            new Place(7, 50, 5),
            new Place(8, -24, 9),
            new Place(-27, -72, 6),
            new Place(-42, -72, 5),
            new Place(10, -72, 7),
            new Place(3, 40, 4),
            new Place(5, 2, 4),
            new Place(7, -12, 5),
            new Place(-9, -16, 4),
            new Place(-27, -17, 5),
            new Place(-47, -24, 6),
            new Place(-58, -48, 7),
            new Place(-50, -68, 4));

    private final SeededNoise noise = new SeededNoise(SEED);

    private StonesMap() {}

    /** Returns heights of 0 to 1, row by row, north (the least z) first. */
    public static float[] heights() {
        StonesMap map = new StonesMap();
        float[] heights = new float[SIDE * SIDE];
        IntStream.range(0, SIDE).parallel().forEach(row -> {
            for (int column = 0; column < SIDE; column++) {
                double metres = map.metres(place(column, SIDE), place(row, SIDE));
                heights[row * SIDE + column] = (float) (metres / MOST_METRES);
            }
        });
        return heights;
    }

    private static double place(int index, int side) {
        return 2 * HALF_METRES * index / (side - 1) - HALF_METRES;
    }

    private double metres(double x, double z) {
        double height = MEADOW + 2.6 * rough(x / 46, z / 46, 4, 1.5) + 0.5 * rough(x / 8, z / 8, 2, 9.5);
        height = site(height, MEADOW + 0.4, x, z, 0, 60, 7);
        height = site(height, MEADOW, x, z, -27, -72, 7);
        height = hill(height, x, z);
        height = rock(height, x, z);
        height = site(height, MEADOW + 1, x, z, 8, -24, 11);
        return mountains(gorge(height, x, z), x, z);
    }

    /** Flattens a round place. */
    private static double site(double height, double level, double x, double z, double atX, double atZ, double radius) {
        double distance = distance(x - atX, z - atZ);
        return mix(height, level, ramp((radius + 6 - distance) / 6));
    }

    /** The gentle sides are to the west and south; the cliff faces the rock in the east. */
    private double hill(double height, double x, double z) {
        double distance = distance(x + 64, z + 72) + 5 * rough(x / 24, z / 24, 3, 21.5);
        double top = HILL_TOP + 0.4 * rough(x / 7, z / 7, 2, 33.5);
        double hill = mix(height, top, ramp((62 - distance) / 46));
        double flatTop = site(hill, HILL_TOP, x, z, -40, -72, 6);
        double edge = -34 + 1.6 * rough(x / 9, z / 9, 3, 27.5) * ramp((Math.abs(z + 72) - 3) / 5);
        return mix(height, flatTop, ramp((edge + 4 - x) / 4));
    }

    private double rock(double height, double x, double z) {
        double distance = distance(x - 10, z + 72) + 3.2 * rough(x / 10, z / 10, 3, 41.5);
        double top = ROCK_TOP + 0.3 * rough(x / 6, z / 6, 2, 47.5);
        top = site(top, ROCK_TOP, x, z, 10, -72, 5);
        return mix(height, top, ramp((17 - distance) / 4.5));
    }

    private double gorge(double height, double x, double z) {
        double middle = 20 + 9 * (rough(x / 50, 3.7, 1, 55.5));
        double across = z - middle + 2.4 * rough(x / 11, z / 11, 3, 61.5);
        double floor = GORGE_FLOOR + 1.2 * rough(x / 12, z / 12, 3, 67.5);
        double slanted = across > 0 ? ramp((18 - Math.abs(x + 62)) / 12) : 0;
        double inside = mix(ramp((13 - Math.abs(across)) / 5), ramp((46 - across) / 38), slanted);
        return mix(height, Math.min(floor, height), inside);
    }

    private double mountains(double height, double x, double z) {
        double round = Math.sqrt(Math.sqrt(x * x * x * x + z * z * z * z));
        double outside = round + 9 * rough(x / 22, z / 22, 4, 71.5);
        double steep = 30 * ramp((outside - 104) / 9);
        double above = ramp((outside - 108) / 30);
        return height + steep + above * (16 + 14 * rough(x / 18, z / 18, 4, 77.5));
    }

    /** Returns octaves of noise between -1 and 1. */
    private double rough(double x, double z, int octaves, double layer) {
        double sum = 0;
        double all = 0;
        double amplitude = 1;
        for (int octave = 0; octave < octaves; octave++) {
            sum += amplitude * (2 * noise.at(x, z, layer + octave) - 1);
            all += amplitude;
            amplitude *= 0.5;
            double turned = 2 * (0.8 * x - 0.6 * z) + 5.1;
            z = 2 * (0.6 * x + 0.8 * z) + 17.3;
            x = turned;
        }
        return sum / all;
    }

    private static double distance(double x, double z) {
        return Math.sqrt(x * x + z * z);
    }

    private static double ramp(double t) {
        double s = Math.max(0, Math.min(1, t));
        return s * s * (3 - 2 * s);
    }

    private static double mix(double a, double b, double t) {
        return a + (b - a) * t;
    }

    private static PictureRecipe recipe(String name, DoubleBinaryOperator density) {
        return new PictureRecipe("terrain/stones-" + name + ".png", () -> picture(density));
    }

    private static BufferedImage picture(DoubleBinaryOperator density) {
        BufferedImage picture = new BufferedImage(GROWTH_SIDE, GROWTH_SIDE, BufferedImage.TYPE_INT_RGB);
        for (int row = 0; row < GROWTH_SIDE; row++) {
            for (int column = 0; column < GROWTH_SIDE; column++) {
                double grey = 255 * density.applyAsDouble(place(column, GROWTH_SIDE), place(row, GROWTH_SIDE));
                picture.setRGB(column, row, 0x010101 * (int) Math.round(Math.max(0, Math.min(255, grey))));
            }
        }
        return picture;
    }

    private static double clear(double x, double z, double margins) {
        double clear = 1;
        for (Place place : PLACES) {
            double distance = Math.sqrt((x - place.x) * (x - place.x) + (z - place.z) * (z - place.z));
            clear *= ramp((distance - place.radius * (0.5 + 0.5 * margins)) / 5);
        }
        return clear;
    }

    private static double patches(double x, double z, double metres, double threshold) {
        double coarse = GROWTH_NOISE.at(x / metres, z / metres, 0.5);
        double fine = GROWTH_NOISE.at(2.7 * x / metres, 2.7 * z / metres, 5.5);
        return ramp((0.7 * coarse + 0.3 * fine - threshold) / 0.16);
    }

    private static double rim(double x, double z) {
        double round = Math.sqrt(Math.sqrt(x * x * x * x + z * z * z * z));
        return ramp((round - 84) / 16);
    }
}
