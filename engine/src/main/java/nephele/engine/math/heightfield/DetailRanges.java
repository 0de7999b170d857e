package nephele.engine.math.heightfield;

import java.util.Arrays;
import nephele.engine.math.heightfield.HeightFieldDetail.Tiles;

/**
 * The ranges from which on the tiles of a {@link HeightFieldDetail} may be drawn coarser without an error of more than
 * one allowed distance on screen. Ranges are compared with {@link DetailView#range}: an error of e metres at range r moves
 * a point of the picture by at most {@code scale} · e / r allowed distances.
 *
 * <p>A sample that the next coarser level lacks rests up to {@link #MORPH_START} of the range at its place. Then it rises
 * or falls to the coarser triangles, which it reaches at {@link #MORPH_END}. From {@link #SLIDE_START} to the range
 * it slides on them, along an edge, to a sample that stays; this moves no surface. Ranges at the corners of tiles are the
 * greatest of the tiles that meet there, and bilinear between, so that they, and with them the vertices, depend on the
 * place alone: tiles of one level draw the same edge, and beyond the range the coarser level's, with the same vertices
 * (after Strugar, 2010, Continuous distance-dependent level of detail, whose ranges were the same for a whole level and
 * whose samples slid without rising before).
 */
public final class DetailRanges {
    /** The share of the range at which samples begin to rise or fall. */
    public static final double MORPH_START = 0.6;

    /** The share of the range at which they have reached the coarser triangles. */
    public static final double MORPH_END = 0.95;

    /** The share of the range at which they begin to slide. */
    public static final double SLIDE_START = 0.99;

    /** Stands for a tile that can't be drawn coarser. */
    static final double NEVER = 1e30;

    /** The greatest ratio of the ranges of neighbouring tiles. */
    private static final double STEEPEST = 1.08;

    /**
     * How much ranges change at most over a cell of the next coarser level, a quarter of a tile along each side, as a share
     * of the least: as much as lies between the end of rising and the start of sliding.
     */
    private static final double CHANGE = (STEEPEST - 1) * 2 / 4;

    /** More than the relative rounding of a shader's arithmetic. */
    private static final double ROUNDING = 1e-3;

    private final HeightFieldDetail detail;
    private final double scale;
    /** By level: the range at each corner of the tiles, row-major. */
    private final float[][] corners;

    private DetailRanges(HeightFieldDetail detail, double scale) {
        this.detail = detail;
        this.scale = scale;
        corners = new float[detail.top()][];
        for (int level = 0; level < detail.top(); level++) {
            corners[level] = corners(detail.tiles(level), ranges(level));
        }
    }

    /** @param scale allowed distances on screen of a length of 1 at distance 1, in the middle of the picture */
    public static DetailRanges of(HeightFieldDetail detail, double scale) {
        return new DetailRanges(detail, scale);
    }

    private double[] ranges(int level) {
        Tiles tiles = detail.tiles(level);
        double[] ranges = new double[tiles.columns() * tiles.rows()];
        for (int at = 0; at < ranges.length; at++) {
            int column = at % tiles.columns();
            int row = at / tiles.columns();
            double below = level == 0
                    ? 0
                    : (finerRange(level, column, row) + DetailView.STEEPNESS * diagonal(level, column, row))
                            / MORPH_START
                            * (1 + ROUNDING);
            boolean isNever = below >= NEVER || Float.isInfinite(tiles.coarserError()[at]);
            ranges[at] = isNever ? NEVER : Math.max(below, range(tiles, at));
        }
        limitSlopes(tiles, ranges);
        return ranges;
    }

    /**
     * Returns the range of a tile. Where all samples of a cell have risen by the share k, the error is at most (1 − k) error
     * + k coarser error; shares that differ by d add at most d / 2 · step. The need is linear in k like the range, so the
     * ends decide. Where a sample slides before another one has risen fully, the error adds to that of the coarser level.
     */
    private double range(Tiles tiles, int at) {
        double pad = DetailView.STEEPNESS * tiles.spread()[at];
        double error = tiles.error()[at];
        double coarser = tiles.coarserError()[at];
        double step = tiles.step()[at];
        double rising = MORPH_END - MORPH_START;
        double range = (scale * coarser + pad) / MORPH_END;
        double late = Math.min(1, pad / (rising * range));
        double difference = Math.min(1, CHANGE / rising + late);
        double more = Math.max(0, error + step - coarser) * difference / 2;
        range = Math.max(range, (scale * (coarser + more) + pad) / MORPH_END);
        range = Math.max(range, (scale * (coarser + late * step) + pad) / SLIDE_START);
        return Math.max(range, (scale * (error + difference * step) + pad) / MORPH_START);
    }

    /**
     * Raises ranges until neighbours, also diagonal ones, differ by at most {@link #STEEPEST}. Tiles that are never drawn
     * coarser keep their range and raise no other; what touches them gets a range of its own.
     */
    private void limitSlopes(Tiles tiles, double[] ranges) {
        for (int at = 0; at < ranges.length; at++) {
            if (ranges[at] < NEVER && touchesNever(tiles, ranges, at)) {
                ranges[at] = Math.max(ranges[at], rangeAnyhow(tiles, at));
            }
        }
        for (int at = 0; at < ranges.length; at++) {
            raise(tiles, ranges, at, -1);
        }
        for (int at = ranges.length - 1; at >= 0; at--) {
            raise(tiles, ranges, at, 1);
        }
    }

    private static boolean touchesNever(Tiles tiles, double[] ranges, int at) {
        for (int neighbour = 0; neighbour < 9; neighbour++) {
            int other = neighbour(tiles, at, neighbour % 3 - 1, neighbour / 3 - 1);
            if (other >= 0 && ranges[other] >= NEVER) {
                return true;
            }
        }
        return false;
    }

    /** Raises a tile to what four of its neighbours require: those before it, or after it, in row-major order. */
    private static void raise(Tiles tiles, double[] ranges, int at, int sign) {
        if (ranges[at] >= NEVER) {
            return;
        }
        for (int x = -1; x <= 1; x++) {
            follow(ranges, at, neighbour(tiles, at, x, sign));
        }
        follow(ranges, at, neighbour(tiles, at, sign, 0));
    }

    private static void follow(double[] ranges, int at, int other) {
        if (other >= 0 && ranges[other] < NEVER) {
            ranges[at] = Math.max(ranges[at], ranges[other] / STEEPEST);
        }
    }

    private static int neighbour(Tiles tiles, int at, int x, int z) {
        int column = at % tiles.columns() + x;
        int row = at / tiles.columns() + z;
        return column < 0 || row < 0 || column >= tiles.columns() || row >= tiles.rows()
                ? -1
                : row * tiles.columns() + column;
    }

    /** Returns the range of a tile whose samples may rise and slide unequally far. */
    private double rangeAnyhow(Tiles tiles, int at) {
        double step = tiles.step()[at];
        double error = Math.min(tiles.error()[at] + 1.5 * step, tiles.coarserError()[at] + step);
        return (scale * error + DetailView.STEEPNESS * tiles.spread()[at]) / MORPH_START;
    }

    private double diagonal(int level, int column, int row) {
        double[] box = new double[6];
        DetailTiles.writeBounds(detail.field(), level, column, row, box);
        return DetailTiles.diagonal(box);
    }

    private static float[] corners(Tiles tiles, double[] ranges) {
        int stride = tiles.columns() + 1;
        float[] corners = new float[stride * (tiles.rows() + 1)];
        Arrays.fill(corners, 0);
        for (int at = 0; at < ranges.length; at++) {
            int first = at / tiles.columns() * stride + at % tiles.columns();
            float range = Math.nextUp((float) ranges[at]);
            for (int corner : new int[] {first, first + 1, first + stride, first + stride + 1}) {
                corners[corner] = Math.max(corners[corner], range);
            }
        }
        return corners;
    }

    /** Returns the greatest range of the next finer level on a tile: if it begins nearer, its four parts are drawn. */
    double finerRange(int level, int column, int row) {
        Tiles finer = detail.tiles(level - 1);
        double greatest = 0;
        for (int z = 2 * row; z <= Math.min(2 * row + 2, finer.rows()); z++) {
            for (int x = 2 * column; x <= Math.min(2 * column + 2, finer.columns()); x++) {
                greatest = Math.max(greatest, corners[level - 1][z * (finer.columns() + 1) + x]);
            }
        }
        return greatest;
    }

    /** Writes the ranges at a tile's corners: least x and z, greatest x, greatest z, greatest both. */
    void writeCorners(int level, int column, int row, float[] out, int at) {
        if (level == detail.top()) {
            Arrays.fill(out, at, at + 4, (float) NEVER);
            return;
        }
        int stride = detail.tiles(level).columns() + 1;
        int first = row * stride + column;
        out[at] = corners[level][first];
        out[at + 1] = corners[level][first + 1];
        out[at + 2] = corners[level][first + stride];
        out[at + 3] = corners[level][first + stride + 1];
    }

    /** Returns the heights that these ranges are for. */
    public HeightFieldDetail detail() {
        return detail;
    }

    /** Returns the allowed distances on screen of a length of 1 at distance 1. */
    public double scale() {
        return scale;
    }
}
