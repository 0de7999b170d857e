package nephele.engine.level.billboard;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import nephele.engine.math.Aabb;
import nephele.engine.math.SeededNoise;

/**
 * Random points that keep a distance from each other. Points are thrown over the whole area first, so that a few of them
 * are spread evenly; when throws fail, the gaps are filled around the points that are there (Bridson 2007, "Fast Poisson
 * Disk Sampling in Arbitrary Dimensions"). Pure: equal arguments give equal points on every machine.
 */
public final class PoissonDisc {
    /** Throws around a point before it has no room beside it; Bridson's k. */
    private static final int AROUND = 30;
    /** Throws in succession that fail before the gaps are filled. */
    private static final int FAILURES = 400;

    private static final int NONE = -1;

    /** Cells to either side in which a point can be too near. */
    private static final int REACH = 2;

    private static final double TURN = 2 * StrictMath.PI;

    /** Decides whether a point may be at a place. */
    @FunctionalInterface
    public interface Chooser {
        /** @param chance a random number in [0, 1) that goes with the throw */
        boolean accepts(double x, double z, double chance);
    }

    private final double spacing;
    private final int most;
    private final SeededNoise noise;
    private final Aabb area;
    private final Chooser chooser;
    /** Side of a cell of an endless grid, whose cells hold at most one point: their diagonal is the least distance. */
    private final double cell;

    /** A table of the cells with open addressing, because an area may have many more cells than points. */
    private final long[] cellKeys;

    private final int[] cellPoints;
    private final List<double[]> points = new ArrayList<>();
    private int thrown;

    private PoissonDisc(Aabb area, double spacing, int most, int seed, Chooser chooser) {
        this.area = area;
        this.spacing = spacing;
        this.most = most;
        this.chooser = chooser;
        noise = new SeededNoise(seed);
        cell = spacing / StrictMath.sqrt(2);
        int size = Integer.highestOneBit(Math.max(8, most)) * 4;
        cellKeys = new long[size];
        cellPoints = new int[size];
        Arrays.fill(cellPoints, NONE);
    }

    /** Returns at most {@code most} points of the area, each x and z; fewer only if hardly any room is left. */
    public static List<double[]> points(Aabb area, double spacing, int most, int seed, Chooser chooser) {
        if (!(area.maxX() > area.minX() && area.maxZ() > area.minZ())) {
            return List.of();
        }
        PoissonDisc disc = new PoissonDisc(area, spacing, most, seed, chooser);
        disc.throwOverAll();
        disc.fillGaps();
        return disc.points;
    }

    private void throwOverAll() {
        for (int failures = 0; failures < FAILURES && points.size() < most; ) {
            int at = thrown++;
            double x = area.minX() + (area.maxX() - area.minX()) * noise.unit(at, 0, 1);
            double z = area.minZ() + (area.maxZ() - area.minZ()) * noise.unit(at, 0, 2);
            failures = offer(x, z, noise.unit(at, 0, 3)) ? 0 : failures + 1;
        }
    }

    /** Every point is a centre once, new ones too. */
    private void fillGaps() {
        for (int centre = 0; centre < points.size() && points.size() < most; centre++) {
            double[] from = points.get(centre);
            for (int i = 0; i < AROUND && points.size() < most; i++) {
                int at = thrown++;
                double angle = TURN * noise.unit(at, 1, 1);
                // Even over the ring from one to two distances.
                double distance = spacing * StrictMath.sqrt(1 + 3 * noise.unit(at, 1, 2));
                double x = from[0] + distance * StrictMath.cos(angle);
                double z = from[1] + distance * StrictMath.sin(angle);
                offer(x, z, noise.unit(at, 1, 3));
            }
        }
    }

    private boolean offer(double x, double z, double chance) {
        boolean isInside = x >= area.minX() && x <= area.maxX() && z >= area.minZ() && z <= area.maxZ();
        if (!isInside || !isFree(x, z) || !chooser.accepts(x, z, chance)) {
            return false;
        }
        cellPoints[slot(column(x), column(z))] = points.size();
        points.add(new double[] {x, z});
        return true;
    }

    private int column(double metres) {
        return (int) Math.floor(metres / cell);
    }

    /** Returns the slot of a cell: the one that holds it, or a free one. */
    private int slot(int x, int z) {
        int mask = cellKeys.length - 1;
        long key = (long) x << 32 | z & 0xffffffffL;
        long mixed = key * 0x9E3779B97F4A7C15L;
        int slot = (int) (mixed >>> 32) & mask;
        while (cellPoints[slot] != NONE && cellKeys[slot] != key) {
            slot = slot + 1 & mask;
        }
        cellKeys[slot] = key;
        return slot;
    }

    /** Returns true if no point is nearer than the spacing. */
    private boolean isFree(double x, double z) {
        int column = column(x);
        int row = column(z);
        for (int i = column - REACH; i <= column + REACH; i++) {
            for (int j = row - REACH; j <= row + REACH; j++) {
                int point = cellPoints[slot(i, j)];
                if (point != NONE) {
                    double dx = points.get(point)[0] - x;
                    double dz = points.get(point)[1] - z;
                    if (dx * dx + dz * dz < spacing * spacing) {
                        return false;
                    }
                }
            }
        }
        return true;
    }
}
