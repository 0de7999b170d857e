package nephele.workshop.prove.geometry;

import nephele.engine.math.heightfield.DetailTiles;
import nephele.engine.math.heightfield.DetailVertex;
import nephele.engine.math.heightfield.DetailView;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.math.heightfield.HeightFieldDetail;

/** The triangles that a view draws of a height field, and their height at every sample that they cover. */
public final class DrawnDetail {
    private static final double ON_EDGE = 1e-9;

    private final HeightField field;
    private final DetailView view;
    private final DetailTiles tiles;
    private final DetailVertex[] corners =
            new DetailVertex[(HeightFieldDetail.TILE_CELLS + 1) * (HeightFieldDetail.TILE_CELLS + 1)];

    /** Receives the corners of each triangle that has an area, counter-clockwise seen from above. */
    @FunctionalInterface
    public interface TriangleVisitor {
        void visit(DetailVertex a, DetailVertex b, DetailVertex c);
    }

    /** Receives the height that is drawn at a sample; for a sample on an edge once for each triangle. */
    @FunctionalInterface
    public interface SampleVisitor {
        void visit(int column, int row, double drawn);
    }

    public DrawnDetail(HeightField field, DetailView view, DetailTiles tiles) {
        this.field = field;
        this.view = view;
        this.tiles = tiles;
    }

    /** Visits all triangles. */
    public void triangles(TriangleVisitor visitor) {
        int cells = HeightFieldDetail.TILE_CELLS;
        int stride = cells + 1;
        for (int tile = 0; tile < tiles.count(); tile++) {
            for (int i = 0; i < corners.length; i++) {
                corners[i] =
                        DetailVertex.of(field, view, tiles.values(), tile * DetailTiles.FLOATS, i % stride, i / stride);
            }
            for (int cell = 0; cell < cells * cells; cell++) {
                int least = cell / cells * stride + cell % cells;
                offer(corners[least], corners[least + stride], corners[least + stride + 1], visitor);
                offer(corners[least], corners[least + stride + 1], corners[least + 1], visitor);
            }
        }
    }

    private static void offer(DetailVertex a, DetailVertex b, DetailVertex c, TriangleVisitor visitor) {
        if (!a.equals(b) && !b.equals(c) && !c.equals(a)) {
            visitor.visit(a, b, c);
        }
    }

    /** Visits the samples under all triangles. */
    public void samples(SampleVisitor visitor) {
        triangles((a, b, c) -> samples(a, b, c, visitor));
    }

    private static void samples(DetailVertex a, DetailVertex b, DetailVertex c, SampleVisitor visitor) {
        double twice = area(a, b, c.column(), c.row());
        if (Math.abs(twice) < ON_EDGE) {
            return;
        }
        int firstRow = (int) Math.ceil(Math.min(a.row(), Math.min(b.row(), c.row())) - ON_EDGE);
        int lastRow = (int) Math.floor(Math.max(a.row(), Math.max(b.row(), c.row())) + ON_EDGE);
        int first = (int) Math.ceil(Math.min(a.column(), Math.min(b.column(), c.column())) - ON_EDGE);
        int last = (int) Math.floor(Math.max(a.column(), Math.max(b.column(), c.column())) + ON_EDGE);
        for (int row = firstRow; row <= lastRow; row++) {
            for (int column = first; column <= last; column++) {
                double ofA = area(b, c, column, row) / twice;
                double ofB = area(c, a, column, row) / twice;
                double ofC = 1 - ofA - ofB;
                if (Math.min(ofA, Math.min(ofB, ofC)) >= -ON_EDGE) {
                    visitor.visit(column, row, ofA * a.height() + ofB * b.height() + ofC * c.height());
                }
            }
        }
    }

    private static double area(DetailVertex a, DetailVertex b, double column, double row) {
        return (b.column() - a.column()) * (row - a.row()) - (b.row() - a.row()) * (column - a.column());
    }
}
