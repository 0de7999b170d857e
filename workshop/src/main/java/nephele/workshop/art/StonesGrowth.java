package nephele.workshop.art;

import java.awt.image.BufferedImage;
import java.util.List;
import java.util.function.DoubleBinaryOperator;
import nephele.engine.math.SeededNoise;
import nephele.workshop.art.picture.PictureRecipe;

/** Where plants grow in the level "Standing stones": pictures that are as bright as plants are dense. */
public final class StonesGrowth {
    private static final int SIDE = 257;
    private static final double HALF_METRES = 128;
    private static final SeededNoise NOISE = new SeededNoise(61);

    public static final List<PictureRecipe> PICTURES = List.of(
            recipe("meadow", (x, z) -> clear(x, z, 1) * (0.25 + 0.75 * patches(x, z, 14, 0.42))),
            recipe("flowers", (x, z) -> clear(x, z, 1.2) * patches(x, z, 17, 0.62)),
            recipe("forest", (x, z) -> clear(x, z, 2) * Math.max(patches(x, z, 34, 0.52), rim(x, z))));

    /** A round place to keep free. */
    private record Place(double x, double z, double radius) {}

    /** Start, gate, temple, basin, top of the hill, goal; then the ways between them. */
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

    private StonesGrowth() {}

    private static PictureRecipe recipe(String name, DoubleBinaryOperator density) {
        return new PictureRecipe("terrain/stones-" + name + ".png", () -> picture(density));
    }

    private static BufferedImage picture(DoubleBinaryOperator density) {
        BufferedImage picture = new BufferedImage(SIDE, SIDE, BufferedImage.TYPE_INT_RGB);
        for (int row = 0; row < SIDE; row++) {
            for (int column = 0; column < SIDE; column++) {
                double grey = 255 * density.applyAsDouble(place(column), place(row));
                picture.setRGB(column, row, 0x010101 * (int) Math.round(Math.max(0, Math.min(255, grey))));
            }
        }
        return picture;
    }

    private static double place(int index) {
        return 2 * HALF_METRES * index / (SIDE - 1) - HALF_METRES;
    }

    private static double clear(double x, double z, double margins) {
        double clear = 1;
        for (Place place : PLACES) {
            double distance = Math.sqrt((x - place.x) * (x - place.x) + (z - place.z) * (z - place.z));
            clear *= step((distance - place.radius * (0.5 + 0.5 * margins)) / 5);
        }
        return clear;
    }

    private static double patches(double x, double z, double metres, double threshold) {
        double coarse = NOISE.at(x / metres, z / metres, 0.5);
        double fine = NOISE.at(2.7 * x / metres, 2.7 * z / metres, 5.5);
        return step((0.7 * coarse + 0.3 * fine - threshold) / 0.16);
    }

    private static double rim(double x, double z) {
        double round = Math.sqrt(Math.sqrt(x * x * x * x + z * z * z * z));
        return step((round - 84) / 16);
    }

    private static double step(double t) {
        double s = Math.max(0, Math.min(1, t));
        return s * s * (3 - 2 * s);
    }
}
