package nephele.engine.level.layout;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import nephele.engine.math.Aabb;
import nephele.engine.math.Plane;
import nephele.engine.math.bvh.ItemList;
import nephele.engine.math.bvh.SpatialIndex;

/**
 * The space that shapes leave free, as boxes of different sizes. Cuts go along the shapes' bounds, so that boxes along
 * the axes leave exactly the space between them; around other shapes cells are halved down to a least size, and what
 * then still meets a shape counts as solid. So no free cell is behind a closed wall.
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

    private final List<Shape> shapes;
    private final List<Aabb> cells = new ArrayList<>();
    private SpatialIndex index;
    private int visited;
    private long comparisons;

    private FreeCells(List<Shape> shapes) {
        this.shapes = shapes;
    }

    /** Divides a box. */
    static FreeCells of(List<Shape> shapes, Aabb world) {
        FreeCells free = new FreeCells(shapes);
        int[] all = new int[shapes.size()];
        Arrays.setAll(all, i -> i);
        free.divide(world, all);
        free.index = SpatialIndex.of(free.cells);
        return free;
    }

    int size() {
        return cells.size();
    }

    Aabb cell(int index) {
        return cells.get(index);
    }

    /** Returns the cells that touch a box, in ascending order. */
    ItemList touching(Aabb box) {
        ItemList found = new ItemList();
        index.overlapping(box, found);
        found.sort();
        return found;
    }

    private void divide(Aabb cell, int[] near) {
        visited++;
        comparisons += near.length;
        int[] inside = new int[near.length];
        int count = 0;
        for (int shape : near) {
            switch (overlap(shapes.get(shape), cell)) {
                case WHOLE:
                    return;
                case PART:
                    inside[count++] = shape;
                    break;
                case NONE:
                    break;
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

    private enum Overlap {
        NONE,
        PART,
        WHOLE
    }

    private static Overlap overlap(Shape shape, Aabb cell) {
        Aabb box = shape.bounds();
        boolean isApart = false;
        boolean isWhole = true;
        for (int axis = 0; axis < 3; axis++) {
            double below = least(box, axis) - least(cell, axis);
            double above = greatest(cell, axis) - greatest(box, axis);
            isApart |= least(box, axis) > greatest(cell, axis) - LEAST_GAP_METRES;
            isApart |= greatest(box, axis) < least(cell, axis) + LEAST_GAP_METRES;
            isWhole &= below <= LEAST_GAP_METRES && above <= LEAST_GAP_METRES;
        }
        for (int i = 0; i < shape.planes().size() && !isApart; i++) {
            isApart = BoxSide.least(shape.planes().get(i), cell) > -LEAST_GAP_METRES;
            isWhole &= BoxSide.greatest(shape.planes().get(i), cell) <= LEAST_GAP_METRES;
        }
        if (isApart) {
            return Overlap.NONE;
        }
        return isWhole ? Overlap.WHOLE : Overlap.PART;
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
        double bestShare = Double.POSITIVE_INFINITY;
        for (int i = 0; i < count; i++) {
            Aabb box = shapes.get(inside[i]).bounds();
            for (int side = 0; side < 6; side++) {
                int axis = side / 2;
                double at = side % 2 == 0 ? least(box, axis) : greatest(box, axis);
                double from = at - least(cell, axis);
                double to = greatest(cell, axis) - at;
                double share = Math.abs(from - to) / (from + to);
                if (from > LEAST_GAP_METRES && to > LEAST_GAP_METRES && share < bestShare) {
                    best = new Cut(axis, at);
                    bestShare = share;
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
                : new Cut(longest, (least(cell, longest) + greatest(cell, longest)) / 2);
    }

    private static double side(Aabb box, int axis) {
        return greatest(box, axis) - least(box, axis);
    }

    static double least(Aabb box, int axis) {
        return axis == 0 ? box.minX() : axis == 1 ? box.minY() : box.minZ();
    }

    static double greatest(Aabb box, int axis) {
        return axis == 0 ? box.maxX() : axis == 1 ? box.maxY() : box.maxZ();
    }
}
