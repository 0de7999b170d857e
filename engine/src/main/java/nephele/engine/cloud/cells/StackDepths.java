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

    /** Optical depths along rays through the cells of one box, a sample a cell, without those where all around is empty. Immutable. */
    private static final class DepthWalk {
        private final float[] densities;
        private final byte[] distances;
        private final double perMetre;
        private final double minX;
        private final double minY;
        private final double minZ;
        private final double perX;
        private final double perY;
        private final double perZ;
        private final int lastX;
        private final int lastY;
        private final int lastZ;
        private final int row;
        private final int slice;

        private DepthWalk(DensityCells density) {
            CellBox cells = density.cells();
            densities = density.densities();
            distances = density.distances();
            perMetre = density.greatestPerMetre();
            minX = cells.box().minX();
            minY = cells.box().minY();
            minZ = cells.box().minZ();
            perX = 1 / cells.sizeX();
            perY = 1 / cells.sizeY();
            perZ = 1 / cells.sizeZ();
            lastX = cells.nx() - 1;
            lastY = cells.ny() - 1;
            lastZ = cells.nz() - 1;
            row = cells.nx();
            slice = cells.nx() * cells.ny();
        }

        /**
         * Returns the optical depth between two distances from a point. Places outside of the box count as the nearest ones of it.
         *
         * @param dx unit direction, {@code dy} and {@code dz} likewise
         */
        double along(double x, double y, double z, double dx, double dy, double dz, double from, double to) {
            double acrossX = dx * perX;
            double acrossY = dy * perY;
            double acrossZ = dz * perZ;
            double perStep = Math.max(Math.abs(acrossX), Math.max(Math.abs(acrossY), Math.abs(acrossZ)));
            int steps = (int) Math.max(1, Math.ceil((to - from) * perStep));
            double step = (to - from) / steps;
            double u = (x + (from + 0.5 * step) * dx - minX) * perX - 0.5;
            double v = (y + (from + 0.5 * step) * dy - minY) * perY - 0.5;
            double w = (z + (from + 0.5 * step) * dz - minZ) * perZ - 0.5;
            double stepU = step * acrossX;
            double stepV = step * acrossY;
            double stepW = step * acrossZ;
            double sum = 0;
            int n = 0;
            while (n < steps) {
                double cu = clamped(u + n * stepU, lastX);
                double cv = clamped(v + n * stepV, lastY);
                double cw = clamped(w + n * stepW, lastZ);
                // A step is at most a cell long, so that many of them stay where linear filtering sees no density.
                int empty = distances[((int) (cw + 0.5) * slice) + ((int) (cv + 0.5) * row) + (int) (cu + 0.5)];
                if (empty > 0) {
                    n += empty;
                } else {
                    sum += density(cu, cv, cw);
                    n++;
                }
            }
            return sum * step * perMetre;
        }

        private static double clamped(double cells, int last) {
            return cells < 0 ? 0 : cells > last ? last : cells;
        }

        private double density(double u, double v, double w) {
            int i = (int) u;
            int j = (int) v;
            int k = (int) w;
            double ofU = u - i;
            double ofV = v - j;
            int at = k * slice + j * row + i;
            int right = i < lastX ? 1 : 0;
            int over = j < lastY ? row : 0;
            double near = plane(at, right, over, ofU, ofV);
            return near + (w - k) * (plane(k < lastZ ? at + slice : at, right, over, ofU, ofV) - near);
        }

        private double plane(int at, int right, int over, double ofU, double ofV) {
            double low = densities[at] + ofU * (densities[at + right] - densities[at]);
            double high = densities[at + over] + ofU * (densities[at + over + right] - densities[at + over]);
            return low + ofV * (high - low);
        }
    }
}
