package nephele.editor.draw;

import nephele.editor.pane.MarkColour;
import nephele.editor.pane.PaneCamera.PaneSize;
import nephele.editor.pane.PlanCamera;
import nephele.engine.math.Vec3;
import nephele.engine.render.line.LineCanvas;
import nephele.engine.render.line.LineColour;
import nephele.engine.render.pass.overlay.OverlayCanvas;
import nephele.engine.render.pass.overlay.OverlayColour;

/** The grid of a plan: lines, the two axes, and coordinates along the upper and the left border. */
record PlanGrid(PlanCamera camera, PaneSize size, GridSpacing spacing, MarkPalette palette, double pixelsPerPoint) {
    private static final double EM_POINTS = 11;
    private static final double STRIP_POINTS = 17;

    /** Left to the symbol of the axes. */
    private static final double FREE_BELOW_POINTS = 70;

    /** The pictures' two directions. */
    private enum Direction {
        ACROSS,
        UPWARDS
    }

    /** Adds lines, finer ones first. */
    void addLines(LineCanvas lines) {
        if (spacing.minorMetres() / camera.metresPerPixel() >= 4) {
            addAll(lines, spacing.minorMetres(), palette.of(MarkColour.GRID));
        }
        addAll(lines, spacing.majorMetres(), palette.of(MarkColour.GRID_MAJOR));
        for (Direction direction : Direction.values()) {
            // The line through 0 in one direction is the axis of the other one.
            Direction along = direction == Direction.ACROSS ? Direction.UPWARDS : Direction.ACROSS;
            addLine(lines, direction, 0, palette.of(axisColour(axis(along))), 1.5 * pixelsPerPoint);
        }
    }

    private void addAll(LineCanvas lines, double metres, LineColour colour) {
        for (Direction direction : Direction.values()) {
            double[] range = range(direction);
            for (double at = Math.ceil(range[0] / metres); at * metres <= range[1]; at++) {
                addLine(lines, direction, at * metres, colour, 1);
            }
        }
    }

    private void addLine(
            LineCanvas lines, Direction direction, double coordinate, LineColour colour, double widthPixels) {
        // At half a pixel, a line of one pixel is as sharp as it can be.
        double at = Math.floor(pixel(direction, coordinate)) + 0.5;
        boolean isAcross = direction == Direction.ACROSS;
        double[] from = isAcross ? new double[] {at, 0} : new double[] {0, at};
        double[] to = isAcross ? new double[] {at, size.height()} : new double[] {size.width(), at};
        lines.screenLine(from, to, colour, widthPixels);
    }

    /** Adds coordinates in metres. */
    void addLabels(OverlayCanvas texts) {
        double width = size.width() / pixelsPerPoint;
        OverlayColour ground = palette.plate();
        OverlayColour ink = OverlayColour.opaque(palette == MarkPalette.ON_DARK ? 0xb6bec7 : 0x4a525b);
        texts.rectangle(0, 0, width, STRIP_POINTS, ground);
        double metres = spacing.labelMetres();
        for (Direction direction : Direction.values()) {
            double[] range = range(direction);
            for (double at = Math.ceil(range[0] / metres); at * metres <= range[1]; at++) {
                addLabel(texts, direction, at * metres, new OverlayColour[] {ink, ground});
            }
        }
    }

    /** @param inkAndGround colours of letters and of the plate behind them */
    private void addLabel(OverlayCanvas texts, Direction direction, double coordinate, OverlayColour[] inkAndGround) {
        String text = GridSpacing.text(coordinate);
        double at = pixel(direction, coordinate) / pixelsPerPoint;
        if (direction == Direction.ACROSS) {
            texts.text(at + 3, STRIP_POINTS - 5, EM_POINTS, inkAndGround[0], text);
        } else if (at > 2 * STRIP_POINTS && at < size.height() / pixelsPerPoint - FREE_BELOW_POINTS) {
            texts.rectangle(0, at - STRIP_POINTS, texts.width(EM_POINTS, text) + 6, STRIP_POINTS, inkAndGround[1]);
            texts.text(3, at - 5, EM_POINTS, inkAndGround[0], text);
        }
    }

    private double[] range(Direction direction) {
        boolean isAcross = direction == Direction.ACROSS;
        double half = (isAcross ? size.width() : size.height()) / 2.0 * camera.metresPerPixel();
        double middle = coordinate(direction, camera.centre());
        return new double[] {middle - half, middle + half};
    }

    private double pixel(Direction direction, double coordinate) {
        Vec3 to = axis(direction);
        boolean isAcross = direction == Direction.ACROSS;
        double sign = to.x() + to.y() + to.z();
        double metres = (coordinate - coordinate(direction, camera.centre())) * sign / camera.metresPerPixel();
        return isAcross ? size.width() / 2.0 + metres : size.height() / 2.0 - metres;
    }

    private double coordinate(Direction direction, Vec3 at) {
        Vec3 to = axis(direction);
        return at.dot(new Vec3(Math.abs(to.x()), Math.abs(to.y()), Math.abs(to.z())));
    }

    private Vec3 axis(Direction direction) {
        return direction == Direction.ACROSS ? camera.right() : camera.up();
    }

    private static MarkColour axisColour(Vec3 axis) {
        if (axis.x() != 0) {
            return MarkColour.AXIS_X;
        }
        return axis.y() != 0 ? MarkColour.AXIS_Y : MarkColour.AXIS_Z;
    }
}
