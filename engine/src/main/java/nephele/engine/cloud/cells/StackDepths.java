package nephele.engine.cloud.cells;

import java.util.List;
import nephele.engine.math.Aabb;

/**
 * Optical depths of rays through a cloud's cells, a sample a cell. In a layer a walk begins in the boxes of one level
 * and goes on in the next wider ones after fixed distances, so that it does not depend on where the boxes' sides are.
 * Immutable.
 */
final class StackDepths {
    private static final int NEAR_LEVELS = 2;

    private final List<DensityCells> density;
    private final List<DepthWalk> walks;
    private final boolean isLayer;

    /** @param isLayer whether the cells end at no side */
    StackDepths(List<DensityCells> density, boolean isLayer) {
        this.density = density;
        this.isLayer = isLayer;
        walks = density.stream().map(DepthWalk::new).toList();
    }

    /** Returns the level whose cells are as wide as these, or the narrowest wider one that contains a point. */
    int level(double x, double z, double cellMetres) {
        int level = 0;
        while (level + 1 < density.size() && !serves(density.get(level).cells(), x, z, cellMetres)) {
            level++;
        }
        return level;
    }

    private static boolean serves(CellBox cells, double x, double z, double cellMetres) {
        double most = (LayerGrid.REACH + LayerGrid.SLACK) * cells.sizeX();
        return cells.sizeX() >= 0.9 * cellMetres
                && Math.abs(x - (cells.box().minX() + cells.box().maxX()) / 2) <= most
                && Math.abs(z - (cells.box().minZ() + cells.box().maxZ()) / 2) <= most;
    }

    /**
     * Returns the optical depth from a point to the outside, also from a point outside.
     *
     * @param level of the cells at the point
     * @param dx unit direction, {@code dy} and {@code dz} likewise
     */
    double from(int level, double x, double y, double z, double dx, double dy, double dz) {
        return from(level, density.size(), x, y, z, dx, dy, dz);
    }

    /** Returns the optical depth up to as far as some levels reach: enough beside greater depths. */
    double nearBy(int level, double x, double y, double z, double dx, double dy, double dz) {
        return from(level, Math.min(density.size(), level + NEAR_LEVELS), x, y, z, dx, dy, dz);
    }

    private double from(int level, int levels, double x, double y, double z, double dx, double dy, double dz) {
        Aabb box = density.get(Math.min(level, density.size() - 1)).cells().box();
        double enter = Math.max(0, entry(y, dy, box.minY(), box.maxY()));
        double exit = exit(y, dy, box.minY(), box.maxY());
        if (!isLayer) {
            enter = Math.max(
                    enter, Math.max(entry(x, dx, box.minX(), box.maxX()), entry(z, dz, box.minZ(), box.maxZ())));
            exit = Math.min(exit, Math.min(exit(x, dx, box.minX(), box.maxX()), exit(z, dz, box.minZ(), box.maxZ())));
            return enter < exit ? along(0, x, y, z, dx, dy, dz, enter, exit) : 0;
        }
        double across = Math.sqrt(dx * dx + dz * dz);
        double sum = 0;
        for (int n = Math.min(level, density.size() - 1); n < levels && enter < exit; n++) {
            double to = Math.min(exit, LayerGrid.WALK * density.get(n).cells().sizeX() / across);
            if (to > enter) {
                sum += along(n, x, y, z, dx, dy, dz, enter, to);
                enter = to;
            }
        }
        return sum;
    }

    private double along(
            int level, double x, double y, double z, double dx, double dy, double dz, double from, double to) {
        return walks.get(level).along(x, y, z, dx, dy, dz, from, to);
    }

    private static double entry(double from, double direction, double min, double max) {
        if (direction == 0) {
            return from >= min && from <= max ? Double.NEGATIVE_INFINITY : Double.POSITIVE_INFINITY;
        }
        return ((direction > 0 ? min : max) - from) / direction;
    }

    private static double exit(double from, double direction, double min, double max) {
        return direction == 0 ? Double.POSITIVE_INFINITY : ((direction > 0 ? max : min) - from) / direction;
    }
}
