package nephele.editor.draw;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.editor.pane.PaneCamera.PaneSize;
import nephele.editor.pane.PaneKind;
import nephele.editor.pane.PlanCamera;
import nephele.engine.math.Vec3;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.math.heightfield.HeightFieldSurface;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** Lines of terrains in plans lie where their heights say, and their number follows the picture, not the map. */
@Execution(ExecutionMode.CONCURRENT)
class GroundLinesTest {
    private static final PaneSize SIZE = new PaneSize(200, 150);
    private static final double METRES = 120;

    private final PlanSegments minor = new PlanSegments();
    private final PlanSegments major = new PlanSegments();

    private static double wave(double x, double z) {
        return 9 * Math.sin(x / 17) * Math.cos(z / 23) + x / 11;
    }

    /** Returns the wave over a square with the least corner at (−40, −70) and height 0 at 5 m. */
    private static HeightField field(int samples) {
        double cell = METRES / (samples - 1);
        return HeightField.of(new Vec3(-40, 5, -70), cell, cell, samples, samples, (c, r) -> wave(c * cell, r * cell));
    }

    private static PlanCamera camera(PaneKind kind, double metresPerPixel) {
        return new PlanCamera(kind, new Vec3(20, 5, -10), metresPerPixel);
    }

    private static double x(PlanSegments lines, int segment, int end, PlanCamera camera) {
        return camera.centre().x() + (lines.end(segment, 2 * end) - 100) * camera.metresPerPixel();
    }

    private static double z(PlanSegments lines, int segment, int end, PlanCamera camera) {
        return camera.centre().z() + (lines.end(segment, 2 * end + 1) - 75) * camera.metresPerPixel();
    }

    /** The samples of the picture are those of the field or between them, so the lines have the very heights. */
    @Test
    void contourLinesHaveOneHeight() {
        HeightField field = field(61);
        for (double metresPerPixel : new double[] {0.5, 0.07}) {
            PlanCamera camera = camera(PaneKind.TOP, metresPerPixel);
            PlanSegments lines = new PlanSegments();
            ContourLines.add(camera, SIZE, field, lines, lines);
            double interval = ContourLines.interval(camera, SIZE, field);
            assertTrue(lines.count() > 100, lines.count() + " segments");
            for (int i = 0; i < lines.count(); i++) {
                for (int end = 0; end < 2; end++) {
                    double height = HeightFieldSurface.y(field, x(lines, i, end, camera), z(lines, i, end, camera)) - 5;
                    double steps = height / interval;
                    assertEquals(Math.rint(steps), steps, 2e-3, "line " + i + " at " + height + " m");
                }
            }
        }
    }

    @Test
    void aPlaneHasNoContourLinesAndASlopeHasEquallySpacedOnes() {
        HeightField plane = HeightField.of(Vec3.ZERO, 1, 1, 100, 100, (c, r) -> 3);
        ContourLines.add(camera(PaneKind.TOP, 1), SIZE, plane, minor, major);
        assertEquals(0, minor.count() + major.count());
        HeightField slope = HeightField.of(new Vec3(-50, 0, -50), 1, 1, 101, 101, (c, r) -> c * 0.7);
        PlanCamera camera = new PlanCamera(PaneKind.TOP, Vec3.ZERO, 1);
        ContourLines.add(camera, SIZE, slope, minor, major);
        double interval = ContourLines.interval(camera, SIZE, slope);
        assertEquals(5, interval, "70 m in about ten steps");
        for (int i = 0; i < major.count(); i++) {
            assertEquals(0, (x(major, i, 0, camera) + 50) * 0.7 % 25, 1e-3, "every fifth line is strong");
            assertEquals(major.end(i, 0), major.end(i, 2), 1e-4f, "lines run along z");
        }
    }

    @Test
    void theNumberOfLinesFollowsThePicture() {
        ContourLines.add(camera(PaneKind.TOP, 0.8), SIZE, field(129), minor, minor);
        ContourLines.add(camera(PaneKind.TOP, 0.8), SIZE, field(2049), major, major);
        assertEquals(1, major.count() / (double) minor.count(), 0.3);
        PlanSegments near = new PlanSegments();
        ContourLines.add(camera(PaneKind.TOP, 0.01), SIZE, field(2049), near, near);
        assertTrue(near.count() < 2 * major.count(), near.count() + " and " + major.count());
    }

    /** The camera moves by whole pixels: lines that both pictures show are the same ones. */
    @Test
    void linesStayWhileTheCameraMoves() {
        HeightField field = field(300);
        PlanCamera camera = camera(PaneKind.TOP, 0.3);
        PlanCamera moved = new PlanCamera(PaneKind.TOP, camera.centre().plus(new Vec3(0.3 * 7, 0, 0)), 0.3);
        ContourLines.add(camera, SIZE, field, minor, minor);
        ContourLines.add(moved, SIZE, field, major, major);
        int found = 0;
        int inside = 0;
        for (int i = 0; i < major.count(); i++) {
            float left = Math.min(major.end(i, 0), major.end(i, 2));
            float right = Math.max(major.end(i, 0), major.end(i, 2));
            if (left > 10 && right < 180 && major.end(i, 1) > 8 && major.end(i, 1) < 140) {
                inside++;
                found += has(minor, major.end(i, 0) + 7, major.end(i, 1)) ? 1 : 0;
            }
        }
        assertTrue(inside > 50, inside + " lines");
        assertEquals(inside, found);
    }

    private static boolean has(PlanSegments lines, double x, double y) {
        for (int i = 0; i < lines.count(); i++) {
            if (Math.hypot(lines.end(i, 0) - x, lines.end(i, 1) - y) < 2e-3) {
                return true;
            }
        }
        return false;
    }

    /** Blocks of cells never hide a summit; the section has the ground under the centre. */
    @Test
    void outlinesHaveTheGreatestHeightsAndThoseOfTheSection() {
        for (PaneKind kind : new PaneKind[] {PaneKind.FRONT, PaneKind.SIDE}) {
            for (int samples : new int[] {61, 2049}) {
                PlanCamera camera = camera(kind, 0.7);
                PlanSegments lines = new PlanSegments();
                Skyline.add(camera, SIZE, field(samples), new PlanSegments(), lines);
                int onSkyline = 0;
                int onSection = 0;
                for (int i = 0; i < lines.count(); i++) {
                    double metres = (lines.end(i, 0) - 100) * 0.7;
                    double drawn = (75 - lines.end(i, 1)) * 0.7;
                    boolean isOnSkyline = Math.abs(drawn - greatest(kind, metres)) < 0.8;
                    double section = kind == PaneKind.FRONT ? wave(60 + metres, 60) : wave(60, 60 - metres);
                    boolean isOnSection = Math.abs(drawn - section) < 0.2;
                    assertTrue(isOnSkyline || isOnSection, kind + " at " + metres + ": " + drawn);
                    onSkyline += isOnSkyline ? 1 : 0;
                    onSection += isOnSection ? 1 : 0;
                }
                assertTrue(onSkyline > 40 && onSection > 60, onSkyline + " and " + onSection);
            }
        }
    }

    /** Many samples share a pixel; the one that is higher than all others is seen. */
    @Test
    void noSummitIsLost() {
        double cell = METRES / 2048;
        HeightField field =
                HeightField.of(new Vec3(-40, 5, -70), cell, cell, 2049, 2049, (c, r) -> c == 1003 && r == 777 ? 30 : 0);
        for (PaneKind kind : new PaneKind[] {PaneKind.FRONT, PaneKind.SIDE}) {
            PlanSegments sky = new PlanSegments();
            Skyline.add(camera(kind, 0.7), SIZE, field, new PlanSegments(), sky);
            double top = 75;
            for (int i = 0; i < sky.count(); i++) {
                top = Math.min(top, sky.end(i, 1));
            }
            assertEquals(75 - 30 / 0.7, top, 1e-3, kind.toString());
        }
    }

    private static double greatest(PaneKind kind, double metres) {
        double greatest = Double.NEGATIVE_INFINITY;
        for (double along = 0; along <= METRES; along += 0.5) {
            greatest = Math.max(greatest, kind == PaneKind.FRONT ? wave(60 + metres, along) : wave(along, 60 - metres));
        }
        return greatest;
    }

    /** The field's slope rises by 0.7 m a metre, so each label says where it stands. */
    @Test
    void strongerLinesAreLabelledOnceWithTheirHeightWhereThereIsRoom() {
        HeightField slope = HeightField.of(new Vec3(-50, 3, -50), 1, 1, 101, 101, (c, r) -> c * 0.7);
        PlanCamera camera = new PlanCamera(PaneKind.TOP, Vec3.ZERO, 1);
        ContourLines.add(camera, SIZE, slope, minor, major);
        List<GroundLines.Label> labels = GroundLines.labels(major, camera, SIZE, slope);
        assertEquals(
                List.of(25.0, 50.0),
                labels.stream().map(GroundLines.Label::metres).toList());
        for (GroundLines.Label label : labels) {
            assertEquals(label.metres(), (label.x() - 50) * 0.7, 0.1);
            assertEquals(75, label.y(), 3, "in the middle's row");
        }
        assertEquals(2, GroundLines.apart(labels, SIZE, 26).size());
        assertEquals(1, GroundLines.apart(labels, SIZE, 40).size(), "they are 36 pixels apart");
        assertEquals(0, GroundLines.apart(labels, SIZE, 76).size(), "the border is 75 pixels away");
    }
}
