package nephele.engine.cloud.field;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.asset.VoxelGrid;
import nephele.engine.math.Aabb;

/**
 * Values on a rectangle as seen from above, interpolated bilinearly between pixel centres; the picture's top is at −z.
 */
final class PlanMap {
    /** Blocks along a side of a rectangle up to which its bound is exact. */
    private static final int EXACT = 4;

    private final VoxelGrid pixels;
    private final GridAxis alongX;
    private final GridAxis alongZ;
    private final GridAxis.Edge edge;
    private final CellLattice blocks;
    private final int columns;
    private final int rows;

    /**
     * Greatest values in blocks of pixels, in squares of 2 × 2 blocks, and so on to one value for all, so that a bound in
     * a rectangle costs the same whatever its size.
     */
    private final List<double[]> maxima = new ArrayList<>();

    /** @param pixels one layer of voxels, which covers the sides of its box */
    PlanMap(VoxelGrid pixels, GridAxis.Edge edge) {
        this.pixels = pixels;
        this.edge = edge;
        Aabb box = pixels.box();
        alongX = new GridAxis(box.minX(), box.maxX(), pixels.nx(), edge);
        alongZ = new GridAxis(box.minZ(), box.maxZ(), pixels.nz(), edge);
        VoxelMaxima greatest = VoxelMaxima.of(pixels, 1, edge);
        blocks = greatest.lattice(box);
        columns = greatest.columns();
        rows = greatest.rows();
        double[] finest = new double[columns * rows];
        for (int at = 0; at < finest.length; at++) {
            finest[at] = greatest.perMetre(at % columns, 0, at / columns);
        }
        maxima.add(finest);
        while (maxima.get(maxima.size() - 1).length > 1) {
            maxima.add(coarser(maxima.size() - 1));
        }
    }

    private double[] coarser(int level) {
        int width = halved(columns, level + 1);
        double[] coarser = new double[width * halved(rows, level + 1)];
        for (int at = 0; at < coarser.length; at++) {
            int i = 2 * (at % width);
            int k = 2 * (at / width);
            coarser[at] = Math.max(
                    Math.max(block(level, i, k), block(level, i + 1, k)),
                    Math.max(block(level, i, k + 1), block(level, i + 1, k + 1)));
        }
        return coarser;
    }

    private static int halved(int blocks, int times) {
        return (blocks + (1 << times) - 1) >> times;
    }

    /** Returns the greatest value of a block of a level; of the last one beyond it. */
    private double block(int level, int i, int k) {
        int width = halved(columns, level);
        return maxima.get(level)[Math.min(k, halved(rows, level) - 1) * width + Math.min(i, width - 1)];
    }

    double at(double x, double z) {
        double u = alongX.at(x);
        double w = alongZ.at(z);
        int floorU = (int) Math.floor(u);
        int floorW = (int) Math.floor(w);
        double near = row(alongZ.lower(floorW), floorU, u - floorU);
        return near + (row(alongZ.upper(floorW), floorU, u - floorU) - near) * (w - floorW);
    }

    private double row(int k, int floorU, double fraction) {
        double left = pixels.value(alongX.lower(floorU), 0, k);
        return left + (pixels.value(alongX.upper(floorU), 0, k) - left) * fraction;
    }

    boolean isBlack() {
        return maxima.get(maxima.size() - 1)[0] == 0;
    }

    /** Returns an upper bound of the values in a rectangle. */
    double greatest(double fromX, double fromZ, double toX, double toZ) {
        long firstI = block((fromX - blocks.originX()) / blocks.sizeX(), columns);
        long firstK = block((fromZ - blocks.originZ()) / blocks.sizeZ(), rows);
        long lastI = block((toX - blocks.originX()) / blocks.sizeX(), columns);
        long lastK = block((toZ - blocks.originZ()) / blocks.sizeZ(), rows);
        return greatestOfBlocks(firstI, firstK, lastI, lastK);
    }

    private long block(double at, int count) {
        long block = (long) Math.floor(at);
        return edge == GridAxis.Edge.REPEATED ? block : Math.max(0, Math.min(block, count - 1));
    }

    /** Returns an upper bound of a rectangle of blocks, the last ones included; behind the last block follows the first. */
    private double greatestOfBlocks(long firstI, long firstK, long lastI, long lastK) {
        int i = (int) Math.floorMod(firstI, (long) columns);
        int k = (int) Math.floorMod(firstK, (long) rows);
        int lastColumn = i + (int) Math.min(columns - 1, lastI - firstI);
        int lastRow = k + (int) Math.min(rows - 1, lastK - firstK);
        double greatest = unwrapped(i, k, lastColumn, lastRow);
        boolean beginsAgain = lastColumn >= columns;
        if (beginsAgain) {
            greatest = Math.max(greatest, unwrapped(0, k, lastColumn - columns, lastRow));
        }
        if (lastRow >= rows) {
            greatest = Math.max(greatest, unwrapped(i, 0, lastColumn, lastRow - rows));
        }
        if (beginsAgain && lastRow >= rows) {
            greatest = Math.max(greatest, unwrapped(0, 0, lastColumn - columns, lastRow - rows));
        }
        return greatest;
    }

    /** Returns an upper bound of the part of a rectangle that is in the map. */
    private double unwrapped(int firstI, int firstK, int lastI, int lastK) {
        int toI = Math.min(lastI, columns - 1);
        int toK = Math.min(lastK, rows - 1);
        int widest = Math.max(toI - firstI, toK - firstK) / EXACT;
        int halvings = Integer.SIZE - Integer.numberOfLeadingZeros(widest);
        int level = Math.min(halvings, maxima.size() - 1);
        double greatest = 0;
        for (int k = firstK >> halvings; k <= toK >> halvings; k++) {
            for (int i = firstI >> halvings; i <= toI >> halvings; i++) {
                greatest = Math.max(greatest, block(level, i, k));
            }
        }
        return greatest;
    }
}
