package nephele.engine.cloud.field;

import nephele.engine.cloud.MajorantWalk;
import nephele.engine.math.Ray;

/**
 * Walks through the cells of a lattice that a span of a ray meets (Amanatides and Woo 1987, "A Fast Voxel Traversal
 * Algorithm for Ray Tracing") and leaves out the cells without extinction.
 */
final class CellWalk implements MajorantWalk {
    /** Where the longest walk ends, so that one along an endless layer without cloud ends at all. */
    private static final double MOST_METRES = 2e7;

    private final Bound bound;
    private final double end;
    private final int stepX;
    private final int stepY;
    private final int stepZ;
    private final double metresX;
    private final double metresY;
    private final double metresZ;
    private long i;
    private long j;
    private long k;
    private double borderX;
    private double borderY;
    private double borderZ;
    private double from;
    private double to;
    private double perMetre;

    /** Upper bounds of the extinction in the cells of a lattice. */
    @FunctionalInterface
    interface Bound {
        /**
         * Returns an upper bound, at least 0, of the extinction per metre in a cell. Rounding can ask for a cell beside the
         * first or last one, which then stands for it.
         */
        double perMetre(long i, long j, long k);
    }

    CellWalk(Ray ray, RaySpan span, CellLattice lattice, Bound bound) {
        this.bound = bound;
        to = span.fromMetres();
        end = span.isEmpty() ? to : Math.min(span.toMetres(), to + MOST_METRES);
        double x = (ray.originX() - lattice.originX()) / lattice.sizeX();
        double y = (ray.originY() - lattice.originY()) / lattice.sizeY();
        double z = (ray.originZ() - lattice.originZ()) / lattice.sizeZ();
        double dx = ray.directionX() / lattice.sizeX();
        double dy = ray.directionY() / lattice.sizeY();
        double dz = ray.directionZ() / lattice.sizeZ();
        stepX = dx < 0 ? -1 : 1;
        stepY = dy < 0 ? -1 : 1;
        stepZ = dz < 0 ? -1 : 1;
        metresX = Math.abs(1 / dx);
        metresY = Math.abs(1 / dy);
        metresZ = Math.abs(1 / dz);
        i = (long) Math.floor(x + to * dx);
        j = (long) Math.floor(y + to * dy);
        k = (long) Math.floor(z + to * dz);
        borderX = border(x, dx, i);
        borderY = border(y, dy, j);
        borderZ = border(z, dz, k);
    }

    /** Returns the ray parameter at which the ray leaves a cell along one axis. */
    private static double border(double origin, double direction, long cell) {
        return direction == 0 ? Double.POSITIVE_INFINITY : (cell + (direction > 0 ? 1 : 0) - origin) / direction;
    }

    @Override
    public boolean next() {
        while (to < end) {
            from = to;
            perMetre = bound.perMetre(i, j, k);
            leaveCell();
            if (perMetre > 0 && to > from) {
                return true;
            }
        }
        return false;
    }

    private void leaveCell() {
        double leave;
        if (borderX <= borderY && borderX <= borderZ) {
            leave = borderX;
            i += stepX;
            borderX += metresX;
        } else if (borderY <= borderZ) {
            leave = borderY;
            j += stepY;
            borderY += metresY;
        } else {
            leave = borderZ;
            k += stepZ;
            borderZ += metresZ;
        }
        to = Math.min(end, Math.max(from, leave));
    }

    @Override
    public double fromMetres() {
        return from;
    }

    @Override
    public double toMetres() {
        return to;
    }

    @Override
    public double perMetre() {
        return perMetre;
    }
}
