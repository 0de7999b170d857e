package nephele.engine.math.heightfield;

import nephele.engine.math.Ray;
import nephele.engine.math.bvh.ItemRayTest;
import nephele.engine.math.bvh.RayHit;

/**
 * A query for the nearest triangle of a {@link HeightField} that a ray hits, nearer blocks first. Used once. Boxes are
 * grown by a margin, so that the result equals that of a test of every triangle.
 */
final class HeightFieldRayQuery {
    /** Greatest ray parameter up to which the part of the field around a ray is sought. */
    private static final double SHORT = 1e6;

    private final HeightField field;
    private final MinMaxPyramid pyramid;
    private final Ray ray;
    private final ItemRayTest test;
    private final RayHit hit;
    private final double margin;
    private final double[] box = new double[6];
    /** The cells over or under the ray, the last included. */
    private int nearColumn;

    private int farColumn;
    private int nearRow;
    private int farRow;
    /** For each level of the descent, the ray parameters at which the ray enters four of its blocks. */
    private final double[] entries;

    /** @param margin in metres; greater than the distance by which the test accepts a near miss of a triangle */
    HeightFieldRayQuery(HeightField field, Ray ray, double margin, ItemRayTest test, RayHit hit) {
        this.field = field;
        this.ray = ray;
        this.margin = margin;
        this.test = test;
        this.hit = hit;
        pyramid = field.pyramid();
        farColumn = field.cellColumns() - 1;
        farRow = field.cellRows() - 1;
        entries = new double[4 * (pyramid.top() + 1)];
    }

    void walk() {
        if (hit.distance() < SHORT) {
            walkNear();
        } else if (isAhead(blockEntry(pyramid.top(), 0, 0))) {
            visit(pyramid.top(), 0, 0);
        }
    }

    /** Begins with the smallest blocks of which two along each side cover what lies over or under the ray. */
    private void walkNear() {
        double toX = ray.originX() + hit.distance() * ray.directionX();
        double toZ = ray.originZ() + hit.distance() * ray.directionZ();
        nearColumn = Math.max(0, cell(Math.min(ray.originX(), toX) - margin, field.x(0), field.cellX()));
        farColumn = Math.min(
                field.cellColumns() - 1, cell(Math.max(ray.originX(), toX) + margin, field.x(0), field.cellX()));
        nearRow = Math.max(0, cell(Math.min(ray.originZ(), toZ) - margin, field.z(0), field.cellZ()));
        farRow = Math.min(field.cellRows() - 1, cell(Math.max(ray.originZ(), toZ) + margin, field.z(0), field.cellZ()));
        if (nearColumn > farColumn || nearRow > farRow) {
            return;
        }
        int firstColumn = nearColumn / MinMaxPyramid.BLOCK_CELLS;
        int lastColumn = farColumn / MinMaxPyramid.BLOCK_CELLS;
        int firstRow = nearRow / MinMaxPyramid.BLOCK_CELLS;
        int lastRow = farRow / MinMaxPyramid.BLOCK_CELLS;
        int level = 0;
        while ((lastColumn >> level) - (firstColumn >> level) > 1 || (lastRow >> level) - (firstRow >> level) > 1) {
            level++;
        }
        visitSquare(level, firstColumn >> level, firstRow >> level);
    }

    /** Returns the cell in which a place lies, which may be outside of the field. */
    private static int cell(double place, double first, double cell) {
        return (int) Math.floor((place - first) / cell);
    }

    private boolean isAhead(double entry) {
        return entry < Double.POSITIVE_INFINITY && entry <= hit.distance();
    }

    private double blockEntry(int level, int column, int row) {
        if (!pyramid.has(level, column, row)) {
            return Double.POSITIVE_INFINITY;
        }
        field.writeBlock(level, column, row, margin, box);
        return ray.boxEntry(box, 0, hit.distance());
    }

    private void visit(int level, int column, int row) {
        if (level == 0) {
            visitCells(column, row);
            return;
        }
        visitSquare(level - 1, 2 * column, 2 * row);
    }

    /** Visits two blocks along each side, the nearest first. */
    private void visitSquare(int level, int column, int row) {
        int from = 4 * level;
        for (int child = 0; child < 4; child++) {
            entries[from + child] = blockEntry(level, column + (child & 1), row + (child >> 1));
        }
        int child = nearestChild(from);
        while (isAhead(entries[from + child])) {
            entries[from + child] = Double.POSITIVE_INFINITY;
            visit(level, column + (child & 1), row + (child >> 1));
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
        int endRow = Math.min(farRow + 1, HeightField.endCell(blockRow, 0, field.cellRows()));
        int endColumn = Math.min(farColumn + 1, HeightField.endCell(blockColumn, 0, field.cellColumns()));
        int firstColumn = Math.max(nearColumn, HeightField.firstCell(blockColumn, 0));
        for (int row = Math.max(nearRow, HeightField.firstCell(blockRow, 0)); row < endRow; row++) {
            for (int column = firstColumn; column < endColumn; column++) {
                for (int half = 0; half < 2; half++) {
                    visitTriangle(column, row, half);
                }
            }
        }
    }

    private void visitTriangle(int column, int row, int half) {
        field.writeTriangle(column, row, half, margin, box);
        if (isAhead(ray.boxEntry(box, 0, hit.distance()))) {
            int triangle = field.triangle(column, row, half);
            double distance = test.hit(ray, triangle, hit.distance());
            if (distance < Double.POSITIVE_INFINITY) {
                hit.offer(triangle, distance);
            }
        }
    }
}
