package nephele.workshop.art.bench;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import nephele.engine.level.Billboards;
import nephele.engine.level.Level;
import nephele.engine.level.Material;
import nephele.engine.level.ModelPlacement;
import nephele.engine.level.Solid;
import nephele.engine.level.TextureMapping;
import nephele.engine.math.Vec3;

/** The billboards of the benchmark scenes: trees on a jittered grid, over one textured ground. */
final class BenchBillboards {
    private static final Vec3 ONE = new Vec3(1, 1, 1);
    private static final double TREE_SPACING_METRES = 3;
    private static final double SQUARE_METRES_PER_TREE = 25;

    private static final double SPACING_METRES = 4;
    private static final double TREE_METRES = 3;

    private BenchBillboards() {}

    /** Adds ground and trees. @param empty with light that leaves textures as they are */
    static Level planted(Level empty, int count) {
        Billboards trees = Billboards.at(
                        "trees",
                        "textures/bench/tree.png",
                        Billboards.Facing.SPHERICAL,
                        TREE_METRES,
                        TREE_METRES,
                        places(count))
                .asBlended();
        return empty.with(List.of(ground()), List.of(plain(2000))).withBillboards(List.of(trees));
    }

    /** Returns the material of the plain. */
    static Material ground() {
        return new Material("ground", ONE, "textures/bench/ground.png", null, null, null, Vec3.ZERO, 8);
    }

    /** Returns level ground around the origin. @param side in metres */
    static Solid plain(double side) {
        return new Solid.Box(
                "ground",
                "ground",
                false,
                TextureMapping.WORLD,
                new Vec3(0, -0.5, 0),
                new Vec3(side, 1, side),
                Map.of());
    }

    private static List<Vec3> places(int count) {
        int side = BenchPath.side(count);
        List<Vec3> places = new ArrayList<>(count);
        for (int i = 0; i < count; i++) {
            float x =
                    (i % side - (side - 1) / 2f + (BenchPixels.random(i, 0, 7) - 0.5f) * 0.7f) * (float) SPACING_METRES;
            float z =
                    (i / side - (side - 1) / 2f + (BenchPixels.random(i, 1, 7) - 0.5f) * 0.7f) * (float) SPACING_METRES;
            places.add(new Vec3(x, 0, z));
        }
        return places;
    }

    /** Adds ground and trees around the origin. */
    static Level forest(Level empty, int count) {
        double side = Math.sqrt(SQUARE_METRES_PER_TREE * count);
        Material leaves = new Material("plants", ONE, "textures/plants.png", null, null, null, Vec3.ZERO, 1);
        List<ModelPlacement> trees = new ArrayList<>();
        trees.add(trees("oak", 1, 2 * count / 5));
        trees.add(trees("fir", 2, 2 * count / 5));
        trees.add(trees("birch", 3, count / 5));
        return empty.with(List.of(ground(), leaves), List.of(plain(side)), List.of(), trees);
    }

    private static ModelPlacement trees(String kind, int seed, int count) {
        return new ModelPlacement(kind, "models/plants/" + kind + ".3d", null, List.of(), "plants", false)
                .over(new Billboards.Field(null, seed, count, TREE_SPACING_METRES, null, 90, null), 0.35);
    }
}
