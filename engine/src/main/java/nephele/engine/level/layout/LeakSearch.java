package nephele.engine.level.layout;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.PriorityQueue;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.ItemList;

/** Searches the shortest way through free cells to the side of the world; exact up to the cells' sizes (Dijkstra). */
final class LeakSearch {
    /** Least width of an opening between two cells. */
    private static final double LEAST_WIDTH_METRES = 2 * FreeCells.LEAST_GAP_METRES;

    /** Share of an opening's side that a way keeps away from its edges. */
    private static final double INSET_SHARE = 0.1;

    private final FreeCells cells;
    private final Aabb world;
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

    LeakSearch(FreeCells cells, Aabb world) {
        this.cells = cells;
        this.world = world;
        metres = new double[cells.size()];
        Arrays.fill(metres, Double.POSITIVE_INFINITY);
        before = new int[cells.size()];
        Arrays.fill(before, -1);
        entered = new Vec3[cells.size()];
        done = new boolean[cells.size()];
    }

    /** Returns the points of the way, the last on a side of the world; empty if there is none. */
    List<Vec3> path(Vec3 from) {
        ItemList first = cells.touching(Aabb.of(List.of(from)));
        for (int i = 0; i < first.size(); i++) {
            reach(first.get(i), -1, 0, from);
        }
        while (!open.isEmpty()) {
            int cell = open.remove().cell();
            if (!done[cell]) {
                done[cell] = true;
                Vec3 out = wayOut(cell);
                if (out != null) {
                    return points(cell, out);
                }
                visitNeighbours(cell);
            }
        }
        return List.of();
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
        ItemList near = cells.touching(cells.cell(cell).grown(FreeCells.LEAST_GAP_METRES));
        for (int i = 0; i < near.size(); i++) {
            int other = near.get(i);
            Vec3 through = done[other] ? null : opening(cells.cell(cell), cells.cell(other), entered[cell]);
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
            double low = Math.max(FreeCells.least(a, axis), FreeCells.least(b, axis));
            double high = Math.min(FreeCells.greatest(a, axis), FreeCells.greatest(b, axis));
            double inset = Math.max(0, INSET_SHARE * (high - low));
            wide += high - low >= LEAST_WIDTH_METRES ? 1 : 0;
            at[axis] = high - low < LEAST_WIDTH_METRES
                    ? (low + high) / 2
                    : Math.max(low + inset, Math.min(high - inset, wanted[axis]));
        }
        return wide >= 2 ? new Vec3(at[0], at[1], at[2]) : null;
    }

    /** Returns the point where a cell meets a side of the world; {@code null} if it does not. */
    private Vec3 wayOut(int cell) {
        Aabb box = cells.cell(cell);
        Vec3 at = entered[cell];
        Vec3 out = null;
        for (int axis = 0; axis < 3; axis++) {
            boolean isLow = FreeCells.least(box, axis) <= FreeCells.least(world, axis);
            boolean isHigh = FreeCells.greatest(box, axis) >= FreeCells.greatest(world, axis);
            if (isLow || isHigh) {
                double side = isLow ? FreeCells.least(world, axis) : FreeCells.greatest(world, axis);
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
