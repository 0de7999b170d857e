package nephele.engine.cloud.cells;

import java.util.List;
import nephele.engine.math.Vec3;

/**
 * A cloud that shades another one.
 *
 * @param density its cells
 * @param isLayer whether they end at no side
 * @param shift from places of the other cloud's cells to those of its own
 * @param weight of its optical depth in the other one's light: clouds with equal τ (1 − g) dim alike
 */
public record ShadingCloud(List<DensityCells> density, boolean isLayer, Vec3 shift, double weight) {
    Walk walk() {
        return new Walk(this, new StackDepths(density, isLayer));
    }

    /** Finds depths. For one thread. */
    static final class Walk {
        private final ShadingCloud of;
        private final StackDepths depths;

        private Walk(ShadingCloud of, StackDepths depths) {
            this.of = of;
            this.depths = depths;
        }

        /** Returns the weighted depth from a point of the other cloud. */
        double from(double x, double y, double z, double cellMetres, Vec3 direction) {
            double ownX = x + of.shift.x();
            double ownZ = z + of.shift.z();
            int level = depths.level(ownX, ownZ, cellMetres);
            return of.weight
                    * depths.from(level, ownX, y + of.shift.y(), ownZ, direction.x(), direction.y(), direction.z());
        }
    }
}
