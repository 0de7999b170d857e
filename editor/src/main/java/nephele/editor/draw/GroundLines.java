package nephele.editor.draw;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import nephele.editor.pane.MarkColour;
import nephele.editor.pane.PaneCamera.PaneSize;
import nephele.editor.pane.PaneKind;
import nephele.editor.pane.PlanCamera;
import nephele.engine.math.Vec3;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.math.heightfield.HeightFieldSurface;
import nephele.engine.render.gl.DisplayColour;
import nephele.engine.render.line.LineCanvas;
import nephele.engine.render.pass.overlay.OverlayCanvas;

/**
 * Terrains in plans: contour lines and the border from above, the outline from the front and the side. The lines are kept
 * until the heights, the camera or the size of the picture changes.
 */
final class GroundLines {
    private static final int MOST_KEPT = 12;
    private static final double EM_POINTS = 10;
    private static final double ROOM_POINTS = 26;

    private final Map<FieldView, Lines> kept = new LinkedHashMap<>();

    /** A field in a plan; fields are compared by identity, and one with other heights is another object. */
    private record FieldView(HeightField field, PlanCamera camera, PaneSize size) {}

    private record Lines(PlanSegments minor, PlanSegments major, List<Label> labels) {}

    /** Adds the terrains that a plan shows. */
    void add(List<HeightField> ground, PlanCamera camera, PaneSize size, Background background, LineCanvas canvas) {
        for (HeightField field : ground) {
            Lines lines = lines(new FieldView(field, camera, size));
            add(lines.minor, background.shade(MarkColour.GROUND), 1, canvas);
            add(lines.major, background.shade(MarkColour.GROUND_MAJOR), 1.4, canvas);
        }
    }

    /** Writes the heights of contour lines. */
    void addLabels(
            List<HeightField> ground,
            PlanCamera camera,
            PaneSize size,
            Background background,
            double pixelsPerPoint,
            OverlayCanvas texts) {
        for (HeightField field : ground) {
            List<Label> labels = lines(new FieldView(field, camera, size)).labels;
            add(labels, size, background, pixelsPerPoint, texts);
        }
    }

    private static void add(PlanSegments lines, DisplayColour colour, double width, LineCanvas canvas) {
        for (int i = 0; i < lines.count(); i++) {
            double[] from = {lines.end(i, 0), lines.end(i, 1)};
            double[] to = {lines.end(i, 2), lines.end(i, 3)};
            canvas.screenLine(from, to, colour, width);
        }
    }

    private Lines lines(FieldView view) {
        Lines lines = kept.remove(view);
        if (lines == null) {
            lines = made(view);
        }
        kept.put(view, lines);
        if (kept.size() > MOST_KEPT) {
            kept.remove(kept.keySet().iterator().next());
        }
        return lines;
    }

    private static Lines made(FieldView view) {
        PlanSegments minor = new PlanSegments();
        PlanSegments major = new PlanSegments();
        if (view.camera.kind() != PaneKind.TOP) {
            Skyline.add(view.camera, view.size, view.field, minor, major);
            return new Lines(minor, major, List.of());
        }
        ContourLines.add(view.camera, view.size, view.field, minor, major);
        List<Label> labels = labels(major, view.camera, view.size, view.field);
        border(view, major);
        return new Lines(minor, major, labels);
    }

    private static void border(FieldView view, PlanSegments lines) {
        HeightField field = view.field;
        double[] x = {field.x(0), field.x(field.cellColumns())};
        double[] z = {field.z(0), field.z(field.cellRows())};
        int[] corners = {0, 0, 1, 0, 1, 1, 0, 1};
        for (int i = 0; i < 4; i++) {
            int next = (i + 1) % 4;
            var from = view.camera
                    .project(new Vec3(x[corners[2 * i]], 0, z[corners[2 * i + 1]]), view.size)
                    .orElseThrow();
            var to = view.camera
                    .project(new Vec3(x[corners[2 * next]], 0, z[corners[2 * next + 1]]), view.size)
                    .orElseThrow();
            lines.add(from.x(), from.y(), to.x(), to.y());
        }
    }

    /** The height of a line in metres above the terrain's centre, and a place on it in pixels. */
    record Label(double metres, double x, double y) {}

    /** @param lines the stronger contour lines of the field in the picture */
    static List<Label> labels(PlanSegments lines, PlanCamera camera, PaneSize size, HeightField field) {
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
            List<Label> labels, PaneSize size, Background background, double pixelsPerPoint, OverlayCanvas texts) {
        DisplayColour ink = background.shade(MarkColour.GROUND_MAJOR);
        DisplayColour plate = background.plate();
        for (Label label : apart(labels, size, ROOM_POINTS * pixelsPerPoint)) {
            String text = PlanGrid.text(label.metres);
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
