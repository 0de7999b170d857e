package nephele.editor.draw;

import java.util.List;
import nephele.editor.pane.Mark;
import nephele.editor.pane.Mark.Visibility;
import nephele.editor.pane.MarkColour;
import nephele.editor.pane.PaneCamera;
import nephele.editor.pane.PaneCamera.PaneSize;
import nephele.engine.math.Vec3;
import nephele.engine.render.gl.DisplayColour;
import nephele.engine.render.line.LineCanvas;
import nephele.engine.render.line.LineLayer;
import nephele.engine.render.pass.overlay.OverlayCanvas;

/** Fills the canvases of a pane with marks. Dark outlines keep them legible on surfaces of any brightness. */
record MarkDrawing(LineCanvas lines, OverlayCanvas texts, Background background, double pixelsPerPoint) {
    private static final DisplayColour OUTLINE = DisplayColour.of(0x000000, 0.55);
    private static final double LINE_POINTS = 1.6;
    private static final double OUTLINE_POINTS = 3.4;
    private static final double HANDLE_POINTS = 8;
    private static final double HANDLE_OUTLINE_POINTS = 11;
    private static final double POLYGON_ALPHA = 0.28;
    private static final double EM_POINTS = 13;
    private static final double LABEL_ASIDE_POINTS = 9;
    private static final double PLATE_MARGIN_POINTS = 4;

    /**
     * Adds marks in this order: areas, lines, handles, labels.
     *
     * @param isOutlined true for dark outlines of lines, which plain backgrounds do not need
     */
    void add(List<Mark> marks, PaneCamera camera, PaneSize size, boolean isOutlined) {
        for (Mark mark : marks) {
            if (mark instanceof Mark.Polygon area) {
                lines.polygon(
                        area.corners(),
                        background.shade(area.colour()).withAlpha(POLYGON_ALPHA),
                        layer(area.visibility()));
            }
        }
        if (isOutlined) {
            marks.forEach(mark -> line(mark, OUTLINE_POINTS, OUTLINE));
        }
        marks.forEach(mark -> line(mark, LINE_POINTS, null));
        for (Mark mark : marks) {
            if (mark instanceof Mark.Stroke stroke) {
                DisplayColour colour = background.shade(stroke.colour());
                lines.line(stroke.from(), stroke.to(), colour, pixelsPerPoint, LineLayer.BEHIND_SURFACES);
            }
        }
        for (Mark mark : marks) {
            if (mark instanceof Mark.Handle handle) {
                handle(handle);
            }
        }
        for (Mark mark : marks) {
            if (mark instanceof Mark.Label label) {
                label(label, camera, size);
            }
        }
    }

    private static LineLayer layer(Visibility visibility) {
        return visibility == Visibility.ALWAYS ? LineLayer.OVER_ALL : LineLayer.BEHIND_SURFACES;
    }

    /** @param colour {@code null} for the mark's own */
    private void line(Mark mark, double widthPoints, DisplayColour colour) {
        if (mark instanceof Mark.Line line) {
            DisplayColour own = background.shade(line.colour());
            boolean isGrid = line.colour() == MarkColour.GRID || line.colour() == MarkColour.GRID_MAJOR;
            if (isGrid && colour != null) {
                return;
            }
            double points = isGrid ? 1 : widthPoints;
            lines.line(
                    line.from(),
                    line.to(),
                    colour == null ? own : colour,
                    points * pixelsPerPoint,
                    layer(line.visibility()));
        }
    }

    private void handle(Mark.Handle handle) {
        lines.square(handle.at(), HANDLE_OUTLINE_POINTS * pixelsPerPoint, DisplayColour.of(0x000000, 0.85));
        lines.square(handle.at(), HANDLE_POINTS * pixelsPerPoint, background.shade(handle.colour()));
    }

    private void label(Mark.Label label, PaneCamera camera, PaneSize size) {
        Vec3 at = label.at();
        camera.project(at, size).ifPresent(spot -> {
            // At the pane's right border the label stays whole, over what it names.
            double rightmost =
                    size.width() / pixelsPerPoint - texts.width(EM_POINTS, label.text()) - PLATE_MARGIN_POINTS;
            double aside = spot.x() / pixelsPerPoint + LABEL_ASIDE_POINTS;
            double x = Math.max(PLATE_MARGIN_POINTS, Math.min(aside, rightmost));
            double baseline = spot.y() / pixelsPerPoint - LABEL_ASIDE_POINTS;
            boolean isInside = spot.x() >= 0 && spot.x() < size.width() && spot.y() >= 0 && spot.y() < size.height();
            if (isInside) {
                plate(label.text(), x, baseline, Background.DARK.shade(label.colour()));
            }
        });
    }

    /** Adds a line of text on a dark plate; lengths in points. */
    void plate(String text, double x, double baseline, DisplayColour colour) {
        double width = texts.width(EM_POINTS, text);
        texts.rectangle(
                x - PLATE_MARGIN_POINTS,
                baseline - EM_POINTS,
                width + 2 * PLATE_MARGIN_POINTS,
                EM_POINTS + 2 * PLATE_MARGIN_POINTS,
                new DisplayColour(0.05f, 0.06f, 0.07f, 0.78f));
        texts.text(x, baseline, EM_POINTS, colour, text);
    }
}
