package nephele.engine.cloud.cells;

/** Optical depths along rays through the cells of one box, a sample a cell, without those where all around is empty. Immutable. */
final class DepthWalk {
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

    DepthWalk(DensityCells density) {
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
