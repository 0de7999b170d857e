package nephele.workshop.art.bench;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.Billboards;
import nephele.engine.level.Level;
import nephele.engine.level.Material;
import nephele.engine.level.ModelPlacement;
import nephele.engine.math.Vec3;

/** The forests of the benchmark scenes: oaks, firs and birches, as dense however many they are. */
final class BenchForest {
    private static final Vec3 ONE = new Vec3(1, 1, 1);
    private static final double SPACING_METRES = 3;
    private static final double SQUARE_METRES_PER_TREE = 25;

    private BenchForest() {}

    /** Adds ground and trees around the origin. */
    static Level planted(Level empty, int count) {
        double side = Math.sqrt(SQUARE_METRES_PER_TREE * count);
        Material leaves = new Material("plants", ONE, "textures/plants.png", null, null, null, Vec3.ZERO, 1);
        List<ModelPlacement> trees = new ArrayList<>();
        trees.add(trees("oak", 1, 2 * count / 5));
        trees.add(trees("fir", 2, 2 * count / 5));
        trees.add(trees("birch", 3, count / 5));
        return empty.with(
                List.of(BenchBillboards.ground(), leaves), List.of(BenchBillboards.plain(side)), List.of(), trees);
    }

    private static ModelPlacement trees(String kind, int seed, int count) {
        return new ModelPlacement(kind, "models/plants/" + kind + ".3d", null, List.of(), "plants", false)
                .over(new Billboards.Field(null, seed, count, SPACING_METRES, null, 90, null), 0.35);
    }
}
