package nephele.editor.draw;

import nephele.editor.pane.PaneCamera.PaneSize;
import nephele.editor.pane.PlanCamera;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.math.heightfield.HeightFieldSurface;

/**
 * The contour lines of a height field in the view from above. Heights are sampled a few pixels apart, on samples of the
 * field where these are closer, so the cost depends on the picture's size and not on the field's.
 */
final class ContourLines {
    private static final double SPACING_PIXELS = 4;

    /** Lines over the range of all heights while the whole field is seen. */
    private static final double LINES = 14;

    /** Nearer views have closer lines, by this power of the part that is seen: small shapes are less steep than wide. */
    private static final double CLOSER_POWER = 0.75;

    /** No view has lines that are closer by more than this. */
    private static final double MOST_CLOSER = 32;

    /** Every so manieth line is drawn stronger. */
    private static final int MAJOR = 5;

    /** A triangle with more lines shows the stronger ones alone. */
    private static final int MOST_IN_TRIANGLE = 3;

    private final PlanCamera camera;
    private final PaneSize size;
    private final HeightField field;
    private final double interval;
    private final PlanSegments minor;
    private final PlanSegments major;

    private ContourLines(PlanCamera camera, PaneSize size, HeightField field, PlanSegments minor, PlanSegments major) {
        this.camera = camera;
        this.size = size;
        this.field = field;
        this.minor = minor;
        this.major = major;
        interval = interval(camera, size, field);
    }

    /** Adds the lines of a field that a picture shows; none of a plane field. */
    static void add(PlanCamera camera, PaneSize size, HeightField field, PlanSegments minor, PlanSegments major) {
        ContourLines lines = new ContourLines(camera, size, field, minor, major);
        if (lines.interval > 0) {
            lines.add();
        }
    }

    /** Returns the metres between two lines: 1, 2 or 5 times a power of 10; 0 for a plane field. */
    static double interval(PlanCamera camera, PaneSize size, HeightField field) {
        double range = field.bounds().maxY() - field.bounds().minY();
        double visible = Math.max(size.width(), size.height()) * camera.metresPerPixel();
        double whole = Math.max(field.cellX() * field.cellColumns(), field.cellZ() * field.cellRows());
        double wanted = range / LINES * Math.max(1 / MOST_CLOSER, Math.min(Math.pow(visible / whole, CLOSER_POWER), 1));
        if (!(wanted > 0)) {
            return 0;
        }
        double power = Math.pow(10, Math.floor(Math.log10(wanted)));
        double digits = wanted / power;
        return power * (digits < 1.5 ? 1 : digits < 3.5 ? 2 : digits < 7.5 ? 5 : 10);
    }

    private void add() {
        double[] xs = places(
                field.x(0), field.cellX(), field.cellColumns(), camera.centre().x(), size.width());
        double[] zs = places(
                field.z(0), field.cellZ(), field.cellRows(), camera.centre().z(), size.height());
        double[] near = new double[xs.length];
        double[] far = new double[xs.length];
        for (int row = 0; row < zs.length; row++) {
            for (int column = 0; column < xs.length; column++) {
                far[column] = HeightFieldSurface.y(field, xs[column], zs[row])
                        - field.origin().y();
            }
            for (int column = 0; row > 0 && column + 1 < xs.length; column++) {
                double[] x = {pixelX(xs[column]), pixelX(xs[column + 1])};
                double[] y = {pixelY(zs[row - 1]), pixelY(zs[row])};
                triangle(new double[] {x[0], x[0], x[1]}, new double[] {y[0], y[1], y[1]}, new double[] {
                    near[column], far[column], far[column + 1]
                });
                triangle(new double[] {x[0], x[1], x[1]}, new double[] {y[0], y[1], y[0]}, new double[] {
                    near[column], far[column + 1], near[column + 1]
                });
            }
            double[] swapped = near;
            near = far;
            far = swapped;
        }
    }

    /** Returns coordinates that cover what is seen; the same ones wherever the camera moves. */
    private double[] places(double first, double cell, int cells, double middle, int pixels) {
        double wanted = SPACING_PIXELS * camera.metresPerPixel();
        double step = wanted >= cell ? cell * Math.floor(wanted / cell) : cell / Math.ceil(cell / wanted);
        double last = first + cell * cells;
        double half = pixels * camera.metresPerPixel() / 2;
        long from = (long) Math.floor((Math.max(middle - half, first) - first) / step);
        long to = (long) Math.ceil((Math.min(middle + half, last) - first) / step);
        double[] places = new double[(int) Math.max(0, to - from + 1)];
        for (int i = 0; i < places.length; i++) {
            // Beside the field it has no height; rounding must not lead there.
            places[i] = Math.min(first + (from + i) * step, last - 1e-9 * cell);
        }
        return places;
    }

    private double pixelX(double x) {
        return size.width() / 2.0 + (x - camera.centre().x()) / camera.metresPerPixel();
    }

    private double pixelY(double z) {
        return size.height() / 2.0 + (z - camera.centre().z()) / camera.metresPerPixel();
    }

    private void triangle(double[] x, double[] y, double[] height) {
        double least = Math.min(height[0], Math.min(height[1], height[2]));
        double greatest = Math.max(height[0], Math.max(height[1], height[2]));
        long first = (long) Math.floor(least / interval) + 1;
        long last = (long) Math.floor(greatest / interval);
        boolean isSteep = last - first >= MOST_IN_TRIANGLE;
        for (long line = first; line <= last; line++) {
            boolean isMajor = line % MAJOR == 0;
            if (isMajor || !isSteep) {
                segment(x, y, height, line * interval, isMajor ? major : minor);
            }
        }
    }

    private static void segment(double[] x, double[] y, double[] height, double level, PlanSegments lines) {
        double[] ends = new double[PlanSegments.NUMBERS];
        int at = 0;
        for (int from = 0; from < 3; from++) {
            int to = (from + 1) % 3;
            if (height[from] < level != height[to] < level) {
                double fraction = (level - height[from]) / (height[to] - height[from]);
                ends[at] = x[from] + fraction * (x[to] - x[from]);
                ends[at + 1] = y[from] + fraction * (y[to] - y[from]);
                at += 2;
            }
        }
        lines.add(ends[0], ends[1], ends[2], ends[3]);
    }
}
