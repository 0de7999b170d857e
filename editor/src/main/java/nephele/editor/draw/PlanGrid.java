package nephele.editor.draw;

import java.math.BigDecimal;
import java.math.RoundingMode;
import nephele.editor.pane.MarkColour;
import nephele.editor.pane.PaneCamera.PaneSize;
import nephele.editor.pane.PlanCamera;
import nephele.engine.math.Vec3;
import nephele.engine.render.gl.DisplayColour;
import nephele.engine.render.line.LineCanvas;
import nephele.engine.render.pass.overlay.OverlayCanvas;

/**
 * The grid of a plan: lines, the two axes, and coordinates along the upper and the left border.
 *
 * @param gridMetres the spacing to which the editor snaps; lines that would be too close are left out
 */
record PlanGrid(PlanCamera camera, PaneSize size, double gridMetres, Background background, double pixelsPerPoint) {
    /** The picture's two directions: across, then upwards. */
    private static final boolean[] DIRECTIONS = {true, false};

    private static final double EM_POINTS = 11;
    private static final double STRIP_POINTS = 17;

    /** Left to the symbol of the axes. */
    private static final double FREE_BELOW_POINTS = 70;

    private static final double LEAST_MINOR_PIXELS = 8;
    private static final double LEAST_LABEL_PIXELS = 72;
    private static final int MINOR_PER_MAJOR = 8;

    /** Returns the grid's own spacing if there is room, otherwise a power of two of it. */
    private double minorMetres() {
        return doubled(gridMetres, LEAST_MINOR_PIXELS * camera.metresPerPixel() * pixelsPerPoint);
    }

    private double majorMetres() {
        return MINOR_PER_MAJOR * minorMetres();
    }

    private double labelMetres() {
        return doubled(majorMetres(), LEAST_LABEL_PIXELS * camera.metresPerPixel() * pixelsPerPoint);
    }

    /** Returns a length times the least power of two, from 1 on, that makes it at least another one. */
    static double doubled(double metres, double least) {
        double factor = Math.max(0, Math.ceil(Math.log(least / metres) / Math.log(2)));
        return metres * Math.pow(2, factor);
    }

    /** Adds lines, finer ones first. */
    void addLines(LineCanvas lines) {
        if (minorMetres() / camera.metresPerPixel() >= 4) {
            addAll(lines, minorMetres(), background.shade(MarkColour.GRID));
        }
        addAll(lines, majorMetres(), background.shade(MarkColour.GRID_MAJOR));
        for (boolean isAcross : DIRECTIONS) {
            // The line through 0 in one direction is the axis of the other one.
            addLine(lines, isAcross, 0, background.shade(axisColour(axis(!isAcross))), 1.5 * pixelsPerPoint);
        }
    }

    private void addAll(LineCanvas lines, double metres, DisplayColour colour) {
        for (boolean isAcross : DIRECTIONS) {
            double[] range = range(isAcross);
            for (double at = Math.ceil(range[0] / metres); at * metres <= range[1]; at++) {
                addLine(lines, isAcross, at * metres, colour, 1);
            }
        }
    }

    private void addLine(
            LineCanvas lines, boolean isAcross, double coordinate, DisplayColour colour, double widthPixels) {
        // At half a pixel, a line of one pixel is as sharp as it can be.
        double at = Math.floor(pixel(isAcross, coordinate)) + 0.5;
        double[] from = isAcross ? new double[] {at, 0} : new double[] {0, at};
        double[] to = isAcross ? new double[] {at, size.height()} : new double[] {size.width(), at};
        lines.screenLine(from, to, colour, widthPixels);
    }

    /** Adds coordinates in metres. */
    void addLabels(OverlayCanvas texts) {
        double width = size.width() / pixelsPerPoint;
        DisplayColour ground = background.plate();
        DisplayColour ink = DisplayColour.opaque(background == Background.DARK ? 0xb6bec7 : 0x4a525b);
        texts.rectangle(0, 0, width, STRIP_POINTS, ground);
        double metres = labelMetres();
        for (boolean isAcross : DIRECTIONS) {
            double[] range = range(isAcross);
            for (double at = Math.ceil(range[0] / metres); at * metres <= range[1]; at++) {
                addLabel(texts, isAcross, at * metres, new DisplayColour[] {ink, ground});
            }
        }
    }

    /** @param inkAndGround colours of letters and of the plate behind them */
    private void addLabel(OverlayCanvas texts, boolean isAcross, double coordinate, DisplayColour[] inkAndGround) {
        String text = text(coordinate);
        double at = pixel(isAcross, coordinate) / pixelsPerPoint;
        if (isAcross) {
            texts.text(at + 3, STRIP_POINTS - 5, EM_POINTS, inkAndGround[0], text);
        } else if (at > 2 * STRIP_POINTS && at < size.height() / pixelsPerPoint - FREE_BELOW_POINTS) {
            texts.rectangle(0, at - STRIP_POINTS, texts.width(EM_POINTS, text) + 6, STRIP_POINTS, inkAndGround[1]);
            texts.text(3, at - 5, EM_POINTS, inkAndGround[0], text);
        }
    }

    private double[] range(boolean isAcross) {
        double half = (isAcross ? size.width() : size.height()) / 2.0 * camera.metresPerPixel();
        double middle = coordinate(isAcross, camera.centre());
        return new double[] {middle - half, middle + half};
    }

    private double pixel(boolean isAcross, double coordinate) {
        Vec3 to = axis(isAcross);
        double sign = to.x() + to.y() + to.z();
        double metres = (coordinate - coordinate(isAcross, camera.centre())) * sign / camera.metresPerPixel();
        return isAcross ? size.width() / 2.0 + metres : size.height() / 2.0 - metres;
    }

    private double coordinate(boolean isAcross, Vec3 at) {
        Vec3 to = axis(isAcross);
        return at.dot(new Vec3(Math.abs(to.x()), Math.abs(to.y()), Math.abs(to.z())));
    }

    private Vec3 axis(boolean isAcross) {
        return isAcross ? camera.right() : camera.up();
    }

    private static MarkColour axisColour(Vec3 axis) {
        if (axis.x() != 0) {
            return MarkColour.AXIS_X;
        }
        return axis.y() != 0 ? MarkColour.AXIS_Y : MarkColour.AXIS_Z;
    }

    /** Returns metres as a short decimal number. */
    static String text(double metres) {
        BigDecimal rounded = BigDecimal.valueOf(metres).setScale(4, RoundingMode.HALF_EVEN);
        return rounded.signum() == 0 ? "0" : rounded.stripTrailingZeros().toPlainString();
    }
}
