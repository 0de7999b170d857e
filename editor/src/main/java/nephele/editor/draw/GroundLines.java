package nephele.editor.draw;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import nephele.editor.pane.MarkColour;
import nephele.editor.pane.PaneCamera.PaneSize;
import nephele.editor.pane.PaneKind;
import nephele.editor.pane.PlanCamera;
import nephele.engine.math.Vec3;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.render.line.LineCanvas;
import nephele.engine.render.line.LineColour;
import nephele.engine.render.pass.overlay.OverlayCanvas;

/**
 * Terrains in plans: contour lines and the border from above, the outline from the front and the side. The lines are kept
 * until the heights, the camera or the size of the picture changes.
 */
final class GroundLines {
    private static final int MOST_KEPT = 12;

    private final Map<Seen, Lines> kept = new LinkedHashMap<>();

    /** A field in a plan; fields are compared by identity, and one with other heights is another object. */
    private record Seen(HeightField field, PlanCamera camera, PaneSize size) {}

    private record Lines(PlanSegments minor, PlanSegments major, List<ContourLabels.Label> labels) {}

    /** Adds the terrains that a plan shows. */
    void add(List<HeightField> ground, PlanCamera camera, PaneSize size, MarkPalette palette, LineCanvas canvas) {
        for (HeightField field : ground) {
            Lines lines = lines(new Seen(field, camera, size));
            add(lines.minor, palette.of(MarkColour.GROUND), 1, canvas);
            add(lines.major, palette.of(MarkColour.GROUND_MAJOR), 1.4, canvas);
        }
    }

    /** Writes the heights of contour lines. */
    void addLabels(
            List<HeightField> ground,
            PlanCamera camera,
            PaneSize size,
            MarkPalette palette,
            double pixelsPerPoint,
            OverlayCanvas texts) {
        for (HeightField field : ground) {
            List<ContourLabels.Label> labels = lines(new Seen(field, camera, size)).labels;
            ContourLabels.add(labels, size, palette, pixelsPerPoint, texts);
        }
    }

    private static void add(PlanSegments lines, LineColour colour, double width, LineCanvas canvas) {
        for (int i = 0; i < lines.count(); i++) {
            double[] from = {lines.end(i, 0), lines.end(i, 1)};
            double[] to = {lines.end(i, 2), lines.end(i, 3)};
            canvas.screenLine(from, to, colour, width);
        }
    }

    private Lines lines(Seen seen) {
        Lines lines = kept.remove(seen);
        if (lines == null) {
            lines = made(seen);
        }
        kept.put(seen, lines);
        if (kept.size() > MOST_KEPT) {
            kept.remove(kept.keySet().iterator().next());
        }
        return lines;
    }

    private static Lines made(Seen seen) {
        PlanSegments minor = new PlanSegments();
        PlanSegments major = new PlanSegments();
        if (seen.camera.kind() != PaneKind.TOP) {
            Skyline.add(seen.camera, seen.size, seen.field, minor, major);
            return new Lines(minor, major, List.of());
        }
        ContourLines.add(seen.camera, seen.size, seen.field, minor, major);
        List<ContourLabels.Label> labels = ContourLabels.of(major, seen.camera, seen.size, seen.field);
        border(seen, major);
        return new Lines(minor, major, labels);
    }

    private static void border(Seen seen, PlanSegments lines) {
        HeightField field = seen.field;
        double[] x = {field.x(0), field.x(field.cellColumns())};
        double[] z = {field.z(0), field.z(field.cellRows())};
        int[] corners = {0, 0, 1, 0, 1, 1, 0, 1};
        for (int i = 0; i < 4; i++) {
            int next = (i + 1) % 4;
            var from = seen.camera
                    .project(new Vec3(x[corners[2 * i]], 0, z[corners[2 * i + 1]]), seen.size)
                    .orElseThrow();
            var to = seen.camera
                    .project(new Vec3(x[corners[2 * next]], 0, z[corners[2 * next + 1]]), seen.size)
                    .orElseThrow();
            lines.add(from.x(), from.y(), to.x(), to.y());
        }
    }
}
