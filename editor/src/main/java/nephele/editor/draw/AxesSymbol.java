package nephele.editor.draw;

import nephele.editor.pane.MarkColour;
import nephele.editor.pane.PaneCamera;
import nephele.editor.pane.PaneCamera.PaneSize;
import nephele.engine.math.Vec3;
import nephele.engine.render.line.LineCanvas;
import nephele.engine.render.line.LineColour;
import nephele.engine.render.pass.overlay.OverlayCanvas;
import nephele.engine.render.pass.overlay.OverlayColour;

/** The directions of the world's axes in a pane, in its lower left corner. */
final class AxesSymbol {
    private static final double FROM_CORNER_POINTS = 34;
    private static final double LENGTH_POINTS = 22;
    private static final double EM_POINTS = 11;

    /** Axes that point to or from the eye have no letter. */
    private static final double LEAST_SEEN = 0.15;

    private AxesSymbol() {}

    static void add(LineCanvas lines, OverlayCanvas texts, PaneCamera camera, PaneSize size, MarkDrawing with) {
        axis(lines, texts, new Along(camera, new Vec3(1, 0, 0), size, with), MarkColour.AXIS_X, "x");
        axis(lines, texts, new Along(camera, new Vec3(0, 1, 0), size, with), MarkColour.AXIS_Y, "y");
        axis(lines, texts, new Along(camera, new Vec3(0, 0, 1), size, with), MarkColour.AXIS_Z, "z");
    }

    private record Along(PaneCamera camera, Vec3 axis, PaneSize size, MarkDrawing with) {
        double[] at(double points) {
            double scale = with.pixelsPerPoint();
            double x = FROM_CORNER_POINTS + points * axis.dot(camera.right());
            double y = -FROM_CORNER_POINTS - points * axis.dot(camera.up());
            return new double[] {scale * x, size.height() + scale * y};
        }

        boolean isSeen() {
            return Math.hypot(axis.dot(camera.right()), axis.dot(camera.up())) > LEAST_SEEN;
        }
    }

    private static void axis(LineCanvas lines, OverlayCanvas texts, Along along, MarkColour colour, String name) {
        if (!along.isSeen()) {
            return;
        }
        double scale = along.with().pixelsPerPoint();
        LineColour shade = along.with().palette().of(colour);
        if (along.with().palette() == MarkPalette.ON_DARK) {
            lines.screenLine(along.at(0), along.at(LENGTH_POINTS), LineColour.of(0, 0.5), 4 * scale);
        }
        lines.screenLine(along.at(0), along.at(LENGTH_POINTS), shade, 2 * scale);
        double[] end = along.at(LENGTH_POINTS + 8);
        if (along.with().palette() == MarkPalette.ON_DARK) {
            OverlayColour shadow = new OverlayColour(0, 0, 0, 0.7f);
            texts.text(end[0] / scale - 2, end[1] / scale + 5, EM_POINTS, shadow, name);
        }
        texts.text(end[0] / scale - 3, end[1] / scale + 4, EM_POINTS, MarkDrawing.overlay(shade), name);
    }
}
