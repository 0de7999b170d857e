package nephele.workshop.prove.geometry;

import nephele.engine.math.heightfield.HeightField;
import nephele.engine.scene.View;

/** The greatest distance in pixels of samples from the places where a view draws them, both within the picture. */
public final class PixelError implements DrawnDetail.SampleVisitor {
    private final HeightField field;
    private final View view;
    private final int width;
    private final int height;
    private final double tanHalfWidth;
    private final double tanHalfHeight;
    private double worst;
    private long samples;

    public PixelError(HeightField field, View view, int width, int height) {
        this.field = field;
        this.view = view;
        this.width = width;
        this.height = height;
        tanHalfWidth = view.projection().tanHalfWidth();
        tanHalfHeight = view.projection().tanHalfHeight();
    }

    @Override
    public void visit(int column, int row, double drawn) {
        double x = field.x(column) - view.eyeX();
        double z = field.z(row) - view.eyeZ();
        double y = field.y(field.height(column, row)) - view.eyeY();
        double up = drawn - field.height(column, row);
        double depth = -view.alongBack(x, y, z);
        double drawnDepth = -view.alongBack(x, y + up, z);
        if (Math.min(depth, drawnDepth) < view.projection().nearMetres()) {
            return;
        }
        double right = view.alongRight(x, y, z) / depth / tanHalfWidth;
        double above = view.alongUp(x, y, z) / depth / tanHalfHeight;
        double drawnRight = view.alongRight(x, y + up, z) / drawnDepth / tanHalfWidth;
        double drawnAbove = view.alongUp(x, y + up, z) / drawnDepth / tanHalfHeight;
        if (isWithin(right, above) && isWithin(drawnRight, drawnAbove)) {
            samples++;
            double across = (drawnRight - right) * width / 2;
            double along = (drawnAbove - above) * height / 2;
            worst = Math.max(worst, Math.sqrt(across * across + along * along));
        }
    }

    private static boolean isWithin(double right, double above) {
        return Math.abs(right) <= 1 && Math.abs(above) <= 1;
    }

    /** Returns the greatest distance. */
    public double worst() {
        return worst;
    }

    /** Returns how often a sample was compared. */
    public long samples() {
        return samples;
    }
}
