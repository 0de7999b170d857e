package nephele.engine.math.heightfield;

import nephele.engine.math.Ray;
import nephele.engine.math.bvh.ItemRayTest;
import nephele.engine.math.bvh.RayHit;

/**
 * A query for the nearest triangle of a {@link HeightField} that a ray hits, nearer blocks first. Used once. Boxes are
 * grown by a margin, so that the result equals that of a test of every triangle.
 */
final class HeightFieldRayQuery {
    private final HeightField field;
    private final MinMaxPyramid pyramid;
    private final Ray ray;
    private final ItemRayTest test;
    private final RayHit hit;
    private final double margin;
    private final double[] box = new double[6];
    /** For each level of the descent, the ray parameters at which the ray enters the four children. */
    private final double[] entries;

    /** @param margin in metres; greater than the distance by which the test accepts a near miss of a triangle */
    HeightFieldRayQuery(HeightField field, Ray ray, double margin, ItemRayTest test, RayHit hit) {
        this.field = field;
        this.ray = ray;
        this.margin = margin;
        this.test = test;
        this.hit = hit;
        pyramid = field.pyramid();
        entries = new double[4 * (pyramid.top() + 1)];
    }

    void walk() {
        if (isAhead(blockEntry(pyramid.top(), 0, 0))) {
            visit(pyramid.top(), 0, 0);
        }
    }

    private boolean isAhead(double entry) {
        return entry < Double.POSITIVE_INFINITY && entry <= hit.distance();
    }

    private double blockEntry(int level, int column, int row) {
        if (!pyramid.has(level, column, row)) {
            return Double.POSITIVE_INFINITY;
        }
        HeightFieldBoxQuery.writeBlock(field, level, column, row, margin, box);
        return ray.boxEntry(box, 0, hit.distance());
    }

    private void visit(int level, int column, int row) {
        if (level == 0) {
            visitCells(column, row);
            return;
        }
        int from = 4 * level;
        for (int child = 0; child < 4; child++) {
            entries[from + child] = blockEntry(level - 1, 2 * column + (child & 1), 2 * row + (child >> 1));
        }
        int child = nearestChild(from);
        while (isAhead(entries[from + child])) {
            entries[from + child] = Double.POSITIVE_INFINITY;
            visit(level - 1, 2 * column + (child & 1), 2 * row + (child >> 1));
            child = nearestChild(from);
        }
    }

    private int nearestChild(int from) {
        int nearest = 0;
        for (int child = 1; child < 4; child++) {
            nearest = entries[from + child] < entries[from + nearest] ? child : nearest;
        }
        return nearest;
    }

    private void visitCells(int blockColumn, int blockRow) {
        int endRow = HeightFieldBoxQuery.endCell(blockRow, 0, field.cellRows());
        int endColumn = HeightFieldBoxQuery.endCell(blockColumn, 0, field.cellColumns());
        for (int row = HeightFieldBoxQuery.firstCell(blockRow, 0); row < endRow; row++) {
            for (int column = HeightFieldBoxQuery.firstCell(blockColumn, 0); column < endColumn; column++) {
                for (int half = 0; half < 2; half++) {
                    visitTriangle(column, row, half);
                }
            }
        }
    }

    private void visitTriangle(int column, int row, int half) {
        HeightFieldBoxQuery.writeTriangle(field, column, row, half, margin, box);
        if (isAhead(ray.boxEntry(box, 0, hit.distance()))) {
            int triangle = HeightFieldBoxQuery.triangle(field, column, row, half);
            double distance = test.hit(ray, triangle, hit.distance());
            if (distance < Double.POSITIVE_INFINITY) {
                hit.offer(triangle, distance);
            }
        }
    }
}
