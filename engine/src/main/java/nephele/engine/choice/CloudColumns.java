package nephele.engine.choice;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;
import nephele.engine.cloud.ExtinctionField;
import nephele.engine.cloud.OpticalDepth;
import nephele.engine.cloud.field.LoadedClouds;
import nephele.engine.level.CloudTechnique;
import nephele.engine.level.Environment;
import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;

/**
 * The loaded clouds of an environment, with the mean optical depth of their upright columns.
 *
 * @param meanDepths of each cloud over the columns that have any, at the start; 0 unless its technique is auto
 */
public record CloudColumns(LoadedClouds loaded, List<Double> meanDepths) {
    /** Columns along x and z. */
    private static final int ACROSS = 9;
    /** Half the width of the part of a layer whose columns are measured. */
    private static final double LAYER_METRES = 12_000;

    private static final double LEAST_DEPTH = 0.01;

    /**
     * Loads the clouds of an environment.
     *
     * @throws AssetException if a picture or grid is unusable
     */
    public static CloudColumns of(Environment environment, AssetSource assets) throws AssetException {
        return of(LoadedClouds.of(environment, assets));
    }

    /** Measures loaded clouds. */
    public static CloudColumns of(LoadedClouds loaded) {
        List<Double> depths = new ArrayList<>();
        for (int i = 0; i < loaded.clouds().size(); i++) {
            boolean isChosen = loaded.clouds().get(i).technique() == CloudTechnique.AUTO;
            depths.add(isChosen ? meanDepth(loaded.flat(i)) : 0);
        }
        return new CloudColumns(loaded, List.copyOf(depths));
    }

    /** Returns the mean optical depth of the upright columns of a field that have any. */
    public static double meanDepth(ExtinctionField field) {
        if (field.isEmpty()) {
            return 0;
        }
        Aabb box = field.bounds();
        boolean isFinite = Double.isFinite(box.maxX());
        double minX = isFinite ? box.minX() : -LAYER_METRES;
        double maxX = isFinite ? box.maxX() : LAYER_METRES;
        double minZ = isFinite ? box.minZ() : -LAYER_METRES;
        double maxZ = isFinite ? box.maxZ() : LAYER_METRES;
        double sum = 0;
        int count = 0;
        for (int i = 0; i < ACROSS * ACROSS; i++) {
            double x = minX + (maxX - minX) * (i % ACROSS + 0.5) / ACROSS;
            double z = minZ + (maxZ - minZ) * (i / ACROSS + 0.5) / ACROSS;
            double depth =
                    OpticalDepth.along(field, new Ray(x, box.minY() - 1, z, 0, 1, 0), 0, box.maxY() - box.minY() + 2);
            if (depth > LEAST_DEPTH) {
                sum += depth;
                count++;
            }
        }
        return count == 0 ? 0 : sum / count;
    }
}
