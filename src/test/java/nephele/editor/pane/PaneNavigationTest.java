package nephele.editor.pane;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.editor.pane.PaneCamera.PanePoint;
import nephele.editor.pane.PaneCamera.PaneSize;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

@Execution(ExecutionMode.CONCURRENT)
class PaneNavigationTest {
    private static final PaneSize SIZE = new PaneSize(640, 360);
    private static final PerspectiveCamera CAMERA = new PerspectiveCamera(new Vec3(3, 2, 7), 25, -12, 60);

    @ParameterizedTest
    @EnumSource(names = {"TOP", "FRONT", "SIDE"})
    void zoomKeepsThePointUnderThePointer(PaneKind kind) {
        PlanCamera camera = new PlanCamera(kind, new Vec3(4, -3, 9), 0.03);
        Vec3 under = camera.ray(77, 301, SIZE).at(2e7);
        PlanCamera zoomed = PlanCamera.zoom(camera, 3, 77, 301, SIZE);
        PanePoint at = zoomed.project(under, SIZE).orElseThrow();
        assertEquals(77, at.x(), 1e-6);
        assertEquals(301, at.y(), 1e-6);
        assertTrue(zoomed.metresPerPixel() < camera.metresPerPixel());
        assertEquals(camera.centre().dot(camera.forward()), zoomed.centre().dot(camera.forward()), 1e-12);
    }

    @Test
    void zoomAtItsLimitDoesNotDrift() {
        PlanCamera camera = new PlanCamera(PaneKind.TOP, new Vec3(4, 0, 9), 1e-4);
        assertEquals(camera, PlanCamera.zoom(camera, 1, 77, 301, SIZE));
    }

    @Test
    void panMovesThePictureWithThePointer() {
        Vec3 grabbed = CAMERA.ray(100, 200, SIZE).at(5);
        PanePoint at = PerspectiveCamera.pan(CAMERA, 31, -17, grabbed, SIZE)
                .project(grabbed, SIZE)
                .orElseThrow();
        assertEquals(131, at.x(), 1e-6);
        assertEquals(183, at.y(), 1e-6);
        PlanCamera plan = new PlanCamera(PaneKind.SIDE, Vec3.ZERO, 0.1);
        PanePoint moved = PlanCamera.pan(plan, 31, -17)
                .project(plan.ray(100, 200, SIZE).at(1), SIZE)
                .orElseThrow();
        assertEquals(131, moved.x(), 1e-6);
        assertEquals(183, moved.y(), 1e-6);
    }

    @Test
    void orbitKeepsThePointAndItsDistance() {
        Vec3 about = CAMERA.ray(500, 90, SIZE).at(4);
        PerspectiveCamera after = PerspectiveCamera.orbit(CAMERA, about, 40, 15);
        PanePoint at = after.project(about, SIZE).orElseThrow();
        assertEquals(500, at.x(), 1e-6);
        assertEquals(90, at.y(), 1e-6);
        assertEquals(4, about.minus(after.eye()).length(), 1e-9);
        assertEquals(-15, after.yawDegrees(), 1e-9);
    }

    @Test
    void dollyApproachesWhatIsUnderThePointerAndBack() {
        Vec3 under = CAMERA.ray(100, 200, SIZE).at(10);
        PerspectiveCamera near = PerspectiveCamera.dolly(CAMERA, 2, CAMERA.ray(100, 200, SIZE), 10);
        double distance = under.minus(near.eye()).length();
        assertTrue(distance < 10);
        assertEquals(100, near.project(under, SIZE).orElseThrow().x(), 1e-6);
        PerspectiveCamera back = PerspectiveCamera.dolly(near, -2, near.ray(100, 200, SIZE), distance);
        assertEquals(0, back.eye().minus(CAMERA.eye()).length(), 1e-9);
    }

    @Test
    void flightIsNoFasterAlongDiagonalsAndUpIsTheWorlds() {
        PerspectiveCamera after = PerspectiveCamera.fly(CAMERA, new Vec3(1, 0, 1), 2.5);
        assertEquals(2.5, after.eye().minus(CAMERA.eye()).length(), 1e-9);
        Vec3 raised = PerspectiveCamera.fly(CAMERA, new Vec3(0, 1, 0), 2.5).eye();
        assertEquals(new Vec3(3, 4.5, 7), raised);
    }

    @Test
    void lookTurnsToThePointerAndStopsAtThePole() {
        PerspectiveCamera after = PerspectiveCamera.look(CAMERA, 100, 50, 0.2);
        assertEquals(5, after.yawDegrees(), 1e-9);
        assertEquals(-22, after.pitchDegrees(), 1e-9);
        assertTrue(PerspectiveCamera.look(CAMERA, 0, 1e4, 0.2).pitchDegrees() > -90);
    }

    @ParameterizedTest
    @EnumSource(names = {"TOP", "FRONT", "SIDE"})
    void focusShowsTheWholeBoxInAPlan(PaneKind kind) {
        Aabb box = new Aabb(-3, 1, 20, 30, 4, 26);
        assertVisible(PlanCamera.focus(new PlanCamera(kind, Vec3.ZERO, 0.02), box, SIZE), box);
    }

    @Test
    void focusShowsTheWholeBoxInPerspectiveAlsoInANarrowPane() {
        Aabb box = new Aabb(-3, 1, 20, 30, 4, 26);
        assertVisible(PerspectiveCamera.focus(CAMERA, box, SIZE), box);
        PaneSize narrow = new PaneSize(100, 600);
        PerspectiveCamera camera = PerspectiveCamera.focus(CAMERA, box, narrow);
        PanePoint at = camera.project(new Vec3(30, 1, 20), narrow).orElseThrow();
        assertTrue(at.x() > 0 && at.x() < 100, at.toString());
        assertEquals(CAMERA, PerspectiveCamera.focus(CAMERA, Aabb.EMPTY, SIZE));
    }

    private static void assertVisible(PaneCamera camera, Aabb box) {
        for (int corner = 0; corner < 8; corner++) {
            Vec3 at = new Vec3(
                    (corner & 1) == 0 ? box.minX() : box.maxX(),
                    (corner & 2) == 0 ? box.minY() : box.maxY(),
                    (corner & 4) == 0 ? box.minZ() : box.maxZ());
            PanePoint seen = camera.project(at, SIZE).orElseThrow();
            boolean isInside = seen.x() > 0 && seen.x() < SIZE.width() && seen.y() > 0 && seen.y() < SIZE.height();
            assertTrue(isInside, camera + " " + seen);
        }
    }
}
