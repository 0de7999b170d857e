package nephele.editor.draw;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import nephele.editor.pane.MarkColour;
import nephele.editor.pane.PaneCamera.PaneSize;
import nephele.editor.pane.PlanCamera;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.math.heightfield.HeightFieldSurface;
import nephele.engine.render.pass.overlay.OverlayCanvas;
import nephele.engine.render.pass.overlay.OverlayColour;

/**
 * The heights of the stronger contour lines, each written once where its line comes nearest to the middle of the picture, so
 * that they stand in a row. A height that would touch another one or the border is left out.
 */
final class ContourLabels {
    private static final double EM_POINTS = 10;
    private static final double ROOM_POINTS = 26;

    private ContourLabels() {}

    /** The height of a line in metres above the terrain's centre, and a place on it in pixels. */
    record Label(double metres, double x, double y) {}

    /** @param lines the stronger contour lines of the field in the picture */
    static List<Label> of(PlanSegments lines, PlanCamera camera, PaneSize size, HeightField field) {
        double interval = ContourLines.interval(camera, size, field);
        Map<Long, Label> nearest = new TreeMap<>();
        for (int i = 0; interval > 0 && i < lines.count(); i++) {
            double x = (lines.end(i, 0) + lines.end(i, 2)) / 2;
            double y = (lines.end(i, 1) + lines.end(i, 3)) / 2;
            double metres = HeightFieldSurface.y(
                            field,
                            camera.centre().x() + (x - size.width() / 2.0) * camera.metresPerPixel(),
                            camera.centre().z() + (y - size.height() / 2.0) * camera.metresPerPixel())
                    - field.origin().y();
            long line = Math.round(metres / interval);
            nearest.merge(
                    line, new Label(line * interval, x, y), (a, b) -> offMiddle(a, size) <= offMiddle(b, size) ? a : b);
        }
        return List.copyOf(nearest.values());
    }

    private static double offMiddle(Label label, PaneSize size) {
        return Math.hypot(label.x - size.width() / 2.0, label.y - size.height() / 2.0);
    }

    /** Writes the labels, from the least height to the greatest. */
    static void add(
            List<Label> labels, PaneSize size, MarkPalette palette, double pixelsPerPoint, OverlayCanvas texts) {
        OverlayColour ink = MarkDrawing.overlay(palette.of(MarkColour.GROUND_MAJOR));
        OverlayColour plate = palette.plate();
        for (Label label : apart(labels, size, ROOM_POINTS * pixelsPerPoint)) {
            String text = GridSpacing.text(label.metres);
            double width = texts.width(EM_POINTS, text);
            double x = label.x / pixelsPerPoint - width / 2;
            double y = label.y / pixelsPerPoint;
            texts.rectangle(x - 2, y - EM_POINTS / 2 - 1, width + 4, EM_POINTS + 2, plate);
            texts.text(x, y + 0.36 * EM_POINTS, EM_POINTS, ink, text);
        }
    }

    /** Returns the labels that have room. */
    static List<Label> apart(List<Label> labels, PaneSize size, double roomPixels) {
        List<Label> kept = new ArrayList<>();
        for (Label label : labels) {
            boolean isInside = label.x > roomPixels
                    && label.x < size.width() - roomPixels
                    && label.y > roomPixels
                    && label.y < size.height() - roomPixels;
            if (isInside
                    && kept.stream()
                            .noneMatch(other -> Math.hypot(label.x - other.x, label.y - other.y) < roomPixels)) {
                kept.add(label);
            }
        }
        return kept;
    }
}
