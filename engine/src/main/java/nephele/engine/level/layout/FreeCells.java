package nephele.engine.level.layout;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.PriorityQueue;
import nephele.engine.math.Aabb;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.ItemList;
import nephele.engine.math.bvh.SpatialIndex;

/**
 * The space that shapes leave free, as boxes of different sizes. Cuts go along the shapes' bounds, so that boxes along
 * the axes leave exactly the space between them; around other shapes cells are halved down to a least size, and what
 * then still meets a shape counts as solid. So no free cell is behind a closed wall. An instance searches one path
 * through the cells.
 */
final class FreeCells {
    /** Gaps narrower than this count as closed. */
    static final double LEAST_GAP_METRES = 1e-3;

    /** Least side of the cells along slanted faces. */
    private static final double LEAST_CELL_METRES = 0.125;

    private static final int MOST_CELLS = 200_000;

    /** Greatest number of comparisons of a shape with a cell: a second of work. What is left then counts as solid. */
    private static final long MOST_COMPARISONS = 20_000_000;

    /** A shape: a convex polyhedron's bounds and planes, or bounds alone for a box that is solid as a whole. */
    record Shape(Aabb bounds, List<Plane> planes) {}

    /** Least width of an opening between two cells. */
    private static final double LEAST_WIDTH_METRES = 2 * LEAST_GAP_METRES;

    /** Fraction of an opening's side that a path keeps away from its edges. */
    private static final double INSET_FRACTION = 0.1;

    private final List<Shape> shapes;
    private final Aabb world;
    private final List<Aabb> cells = new ArrayList<>();
    private final SpatialIndex index;
    private int visited;
    private long comparisons;

    /** The cells' distances along the path from the start, the cells before them and the points where it enters. */
    private final double[] metres;

    private final int[] before;
    private final Vec3[] entered;
    private final boolean[] done;
    private final PriorityQueue<Step> open = new PriorityQueue<>();

    private record Step(double metres, int cell) implements Comparable<Step> {
        @Override
        public int compareTo(Step other) {
            int order = Double.compare(metres, other.metres);
            return order != 0 ? order : Integer.compare(cell, other.cell);
        }
    }

    private FreeCells(List<Shape> shapes, Aabb world) {
        this.shapes = shapes;
        this.world = world;
        int[] all = new int[shapes.size()];
        Arrays.setAll(all, i -> i);
        divide(world, all);
        index = SpatialIndex.of(cells);
        metres = new double[cells.size()];
        Arrays.fill(metres, Double.POSITIVE_INFINITY);
        before = new int[cells.size()];
        Arrays.fill(before, -1);
        entered = new Vec3[cells.size()];
        done = new boolean[cells.size()];
    }

    /**
     * Returns the points of the shortest path from a point between shapes to a side of {@code world}, exact up to the
     * cells' sizes; empty if there is none.
     */
    static List<Vec3> pathOut(List<Shape> shapes, Aabb world, Vec3 from) {
        return new FreeCells(shapes, world).path(from);
    }

    private void divide(Aabb cell, int[] near) {
        visited++;
        comparisons += near.length;
        int[] inside = new int[near.length];
        int count = 0;
        for (int shape : near) {
            if (!isApart(shapes.get(shape), cell)) {
                if (fills(shapes.get(shape), cell)) {
                    return;
                }
                inside[count++] = shape;
            }
        }
        if (count == 0) {
            cells.add(cell);
        } else if (visited < MOST_CELLS && comparisons < MOST_COMPARISONS) {
            Cut cut = cut(cell, inside, count);
            if (cut != null) {
                int[] rest = Arrays.copyOf(inside, count);
                divide(cut.low(cell), rest);
                divide(cut.high(cell), rest);
            }
        }
    }

    private static boolean isApart(Shape shape, Aabb cell) {
        Aabb box = shape.bounds();
        for (int axis = 0; axis < 3; axis++) {
            if (box.least(axis) > cell.greatest(axis) - LEAST_GAP_METRES
                    || box.greatest(axis) < cell.least(axis) + LEAST_GAP_METRES) {
                return true;
            }
        }
        return shape.planes().stream().anyMatch(plane -> plane.leastDistance(cell) > -LEAST_GAP_METRES);
    }

    private static boolean fills(Shape shape, Aabb cell) {
        Aabb box = shape.bounds();
        for (int axis = 0; axis < 3; axis++) {
            if (box.least(axis) - cell.least(axis) > LEAST_GAP_METRES
                    || cell.greatest(axis) - box.greatest(axis) > LEAST_GAP_METRES) {
                return false;
            }
        }
        return shape.planes().stream().allMatch(plane -> plane.greatestDistance(cell) <= LEAST_GAP_METRES);
    }

    /** A plane across an axis. */
    private record Cut(int axis, double at) {
        Aabb low(Aabb c) {
            return new Aabb(
                    c.minX(),
                    c.minY(),
                    c.minZ(),
                    axis == 0 ? at : c.maxX(),
                    axis == 1 ? at : c.maxY(),
                    axis == 2 ? at : c.maxZ());
        }

        Aabb high(Aabb c) {
            return new Aabb(
                    axis == 0 ? at : c.minX(),
                    axis == 1 ? at : c.minY(),
                    axis == 2 ? at : c.minZ(),
                    c.maxX(),
                    c.maxY(),
                    c.maxZ());
        }
    }

    /** Returns the cut along a shape's bounds that is nearest to a middle; {@code null} if the cell is small enough. */
    private Cut cut(Aabb cell, int[] inside, int count) {
        Cut best = null;
        double leastImbalance = Double.POSITIVE_INFINITY;
        for (int i = 0; i < count; i++) {
            Aabb box = shapes.get(inside[i]).bounds();
            for (int side = 0; side < 6; side++) {
                int axis = side / 2;
                double at = side % 2 == 0 ? box.least(axis) : box.greatest(axis);
                double from = at - cell.least(axis);
                double to = cell.greatest(axis) - at;
                double imbalance = Math.abs(from - to) / (from + to);
                if (from > LEAST_GAP_METRES && to > LEAST_GAP_METRES && imbalance < leastImbalance) {
                    best = new Cut(axis, at);
                    leastImbalance = imbalance;
                }
            }
        }
        return best == null ? halved(cell) : best;
    }

    private static Cut halved(Aabb cell) {
        int longest = 0;
        for (int axis = 1; axis < 3; axis++) {
            longest = side(cell, axis) > side(cell, longest) ? axis : longest;
        }
        return side(cell, longest) <= LEAST_CELL_METRES
                ? null
                : new Cut(longest, (cell.least(longest) + cell.greatest(longest)) / 2);
    }

    private static double side(Aabb box, int axis) {
        return box.greatest(axis) - box.least(axis);
    }

    /** Finds the path (Dijkstra). */
    private List<Vec3> path(Vec3 from) {
        ItemList first = touching(Aabb.of(List.of(from)));
        for (int i = 0; i < first.size(); i++) {
            reach(first.get(i), -1, 0, from);
        }
        while (!open.isEmpty()) {
            int cell = open.remove().cell();
            if (!done[cell]) {
                done[cell] = true;
                Vec3 out = exitPoint(cell);
                if (out != null) {
                    return points(cell, out);
                }
                visitNeighbours(cell);
            }
        }
        return List.of();
    }

    /** Returns the cells that touch a box, in ascending order. */
    private ItemList touching(Aabb box) {
        ItemList found = new ItemList();
        index.overlapping(box, found);
        found.sort();
        return found;
    }

    private void reach(int cell, int from, double length, Vec3 at) {
        if (length < metres[cell]) {
            metres[cell] = length;
            before[cell] = from;
            entered[cell] = at;
            open.add(new Step(length, cell));
        }
    }

    private void visitNeighbours(int cell) {
        ItemList near = touching(cells.get(cell).grown(LEAST_GAP_METRES));
        for (int i = 0; i < near.size(); i++) {
            int other = near.get(i);
            Vec3 through = done[other] ? null : opening(cells.get(cell), cells.get(other), entered[cell]);
            if (through != null) {
                double length = metres[cell] + through.minus(entered[cell]).length();
                reach(other, cell, length, through);
            }
        }
    }

    /** Returns the point of the opening between two cells that is nearest to another; {@code null} for none. */
    private static Vec3 opening(Aabb a, Aabb b, Vec3 from) {
        double[] at = new double[3];
        double[] wanted = {from.x(), from.y(), from.z()};
        int wide = 0;
        for (int axis = 0; axis < 3; axis++) {
            double low = Math.max(a.least(axis), b.least(axis));
            double high = Math.min(a.greatest(axis), b.greatest(axis));
            double inset = Math.max(0, INSET_FRACTION * (high - low));
            wide += high - low >= LEAST_WIDTH_METRES ? 1 : 0;
            at[axis] = high - low < LEAST_WIDTH_METRES
                    ? (low + high) / 2
                    : Math.max(low + inset, Math.min(high - inset, wanted[axis]));
        }
        return wide >= 2 ? new Vec3(at[0], at[1], at[2]) : null;
    }

    /** Returns the point where a cell meets a side of the world; {@code null} if it does not. */
    private Vec3 exitPoint(int cell) {
        Aabb box = cells.get(cell);
        Vec3 at = entered[cell];
        Vec3 out = null;
        for (int axis = 0; axis < 3; axis++) {
            boolean isLow = box.least(axis) <= world.least(axis);
            boolean isHigh = box.greatest(axis) >= world.greatest(axis);
            if (isLow || isHigh) {
                double side = isLow ? world.least(axis) : world.greatest(axis);
                Vec3 found = new Vec3(axis == 0 ? side : at.x(), axis == 1 ? side : at.y(), axis == 2 ? side : at.z());
                boolean isNearer =
                        out == null || found.minus(at).length() < out.minus(at).length();
                out = isNearer ? found : out;
            }
        }
        return out;
    }

    private List<Vec3> points(int cell, Vec3 out) {
        List<Vec3> points = new ArrayList<>(List.of(out));
        for (int at = cell; at >= 0; at = before[at]) {
            points.add(entered[at]);
        }
        Collections.reverse(points);
        return points;
    }
}
