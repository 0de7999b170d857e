package nephele.editor.tool.transform;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.editor.pane.Mark;
import nephele.editor.pane.MarkColour;
import nephele.editor.pane.PaneKind;
import nephele.editor.tool.EndedDrags;
import nephele.editor.tool.Pointer.Modifier;
import nephele.editor.tool.ToolEntry;
import nephele.editor.tool.ToolScene;
import nephele.engine.level.Level;
import nephele.engine.level.Solid;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** Each grip makes its own change, snapped, in one step. */
@Execution(ExecutionMode.CONCURRENT)
class TransformToolTest {
    private static final Vec3 CENTRE = new Vec3(0, 1, 0);

    private ToolScene using(ToolEntry entry) {
        return ToolScene.withCube().using(entry).selecting("cube");
    }

    private static Solid.Box cube(ToolScene scene) {
        return (Solid.Box) scene.solid("cube");
    }

    @Test
    void anArrowMovesAlongItsAxisOnly() {
        ToolScene scene = using(TransformTool.MOVE);
        Level before = scene.level();
        Vec3 onArrow = CENTRE.addScaled(60 * scene.metresPerPixel(CENTRE), new Vec3(1, 0, 0));
        scene.stroke(onArrow, onArrow.plus(new Vec3(1.6, 0.05, 0)));
        assertEquals(new Vec3(1.5, 1, 0), cube(scene).centre());
        EndedDrags.assertOneStep(before, scene);
    }

    @Test
    void aCornerMovesInItsPlane() {
        ToolScene scene = using(TransformTool.MOVE).plan(PaneKind.TOP);
        Vec3 corner = new Vec3(0.28, 1, 0.28);
        scene.stroke(corner, corner.plus(new Vec3(0.9, 0, -0.6)));
        assertEquals(new Vec3(1, 1, -0.5), cube(scene).centre());
    }

    @Test
    void aRingTurnsByStepsAndShiftByFinerOnes() {
        ToolScene scene = ToolScene.of(
                        "{\"id\": \"cube\", \"kind\": \"box\", \"centre\": [0, 1, 0], \"size\": [2, 2, 4]}")
                .using(TransformTool.ROTATE)
                .selecting("cube")
                .plan(PaneKind.TOP);
        Vec3 onRing = new Vec3(0, 1, 0.8);
        scene.stroke(onRing, new Vec3(0.8, 1, 0.1));
        assertEquals(new Vec3(4, 2, 2), cube(scene).size());
        scene.press(onRing);
        scene.drag(at(7), Modifier.SHIFT);
        scene.release(at(7));
        Solid.Planes turned = (Solid.Planes) scene.solid("cube");
        double most = turned.planes().stream()
                .map(plane -> plane.normal())
                .filter(normal -> normal.x() > 0.9)
                .mapToDouble(normal -> Math.toDegrees(Math.atan2(-normal.z(), normal.x())))
                .findFirst()
                .orElseThrow();
        assertEquals(5, most, 1e-9);
    }

    /** Returns the place on the ring after a turn from +z. */
    private static Vec3 at(double degrees) {
        double angle = Math.toRadians(degrees);
        return new Vec3(0.8 * Math.sin(angle), 1, 0.8 * Math.cos(angle));
    }

    @Test
    void aSideStretchesAndACornerScalesFromTheOppositeOne() {
        ToolScene scene = using(TransformTool.SCALE);
        scene.stroke(new Vec3(1, 1, 0), new Vec3(2.1, 1, 0));
        assertEquals(new Vec3(3, 2, 2), cube(scene).size());
        assertEquals(new Vec3(0.5, 1, 0), cube(scene).centre());
        scene.document().undo();
        scene.stroke(new Vec3(1, 2, 1), new Vec3(1.95, 3, 2));
        assertEquals(new Vec3(3, 3, 3), cube(scene).size());
        assertEquals(new Vec3(0.5, 1.5, 0.5), cube(scene).centre());
    }

    @Test
    void aSideNeverPassesTheOppositeOne() {
        ToolScene scene = using(TransformTool.SCALE);
        scene.stroke(new Vec3(1, 1, 0), new Vec3(-5, 1, 0));
        assertEquals(new Vec3(0.5, 2, 2), cube(scene).size());
    }

    @Test
    void gripsAreHoveredAndOthersPlacesSelect() {
        ToolScene scene = using(TransformTool.SCALE);
        scene.move(new Vec3(1, 1, 0));
        assertTrue(scene.tool().marks().contains(new Mark.Handle(new Vec3(1, 1, 0), MarkColour.HOVERED)));
        scene.click(new Vec3(5, 0, 0));
        assertTrue(scene.document().selection().isEmpty());
        assertTrue(scene.tool().marks().isEmpty());
    }

    @Test
    void everyEndButTheReleaseRestores() {
        ToolScene scene = using(TransformTool.SCALE);
        Level before = scene.level();
        EndedDrags.restore(scene, new Vec3(1, 1, 0), new Vec3(3, 1, 0));
        assertSame(before, scene.level());
    }
}
