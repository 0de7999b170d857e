package nephele.editor.tool.extrude;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import nephele.editor.brush.BrushText;
import nephele.editor.pane.Mark;
import nephele.editor.pane.PaneKind;
import nephele.editor.tool.EndedDrags;
import nephele.editor.tool.Pointer.Modifier;
import nephele.editor.tool.ToolScene;
import nephele.engine.level.Level;
import nephele.engine.level.Solid;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** The face under the pointer follows it along its normal. */
@Execution(ExecutionMode.CONCURRENT)
class ExtrudeToolTest {
    private static final Vec3 TOP = new Vec3(0, 2, 0);

    private final ToolScene scene = ToolScene.withCube().using(ExtrudeTool.ENTRY);
    private final Level start = scene.level();

    @Test
    void aFaceMovesBySteps() {
        scene.stroke(TOP, new Vec3(0, 3.1, 0));
        scene.assertBox("cube", new Vec3(0, 1.5, 0), new Vec3(2, 3, 2));
        EndedDrags.assertOneStep(start, scene);
    }

    @Test
    void controlMakesANewBrush() {
        scene.stroke(TOP, new Vec3(0, 3.1, 0), Modifier.CONTROL);
        scene.assertBox("cube", new Vec3(0, 1, 0), new Vec3(2, 2, 2));
        scene.assertBox("cube-2", new Vec3(0, 2.5, 0), new Vec3(2, 1, 2));
        EndedDrags.assertOneStep(start, scene);
    }

    @Test
    void aRefusalIsShownAndChangesNothing() {
        scene.stroke(TOP, new Vec3(0, -1, 0));
        assertSame(start, scene.level());
        assertEquals(BrushText.NOTHING_LEFT.words(), scene.session().status());
    }

    @Test
    void aPlanMovesTheSideNearestToThePointer() {
        scene.plan(PaneKind.TOP).stroke(new Vec3(0.9, 0, 0.2), new Vec3(1.5, 0, 0.7));
        scene.assertBox("cube", new Vec3(0.25, 1, 0), new Vec3(2.5, 2, 2));
    }

    @Test
    void theFaceUnderThePointerIsShown() {
        scene.move(TOP);
        Mark.Polygon face =
                assertInstanceOf(Mark.Polygon.class, scene.tool().marks().get(0));
        assertTrue(face.corners().stream().allMatch(corner -> corner.y() == 2));
        scene.move(new Vec3(5, 0, 0));
        assertTrue(scene.tool().marks().isEmpty());
    }

    private static ToolScene three() {
        return ToolScene.of("{\"id\": \"a\", \"kind\": \"box\", \"centre\": [0, 1, 0], \"size\": [2, 2, 2]},"
                        + "{\"id\": \"b\", \"kind\": \"box\", \"centre\": [-3, 1, 0], \"size\": [2, 2, 2]},"
                        + "{\"id\": \"low\", \"kind\": \"box\", \"centre\": [3, 0.5, 0], \"size\": [2, 1, 2]}")
                .using(ExtrudeTool.ENTRY);
    }

    private static double height(ToolScene scene, String id) {
        return ((Solid.Box) scene.solid(id)).size().y();
    }

    @Test
    void facesOfSelectedBrushesInOnePlaneMoveTogether() {
        ToolScene three = three().selecting("a", "b", "low");
        Level before = three.level();
        three.stroke(TOP, new Vec3(0, 3, 0));
        assertEquals(List.of(3.0, 3.0, 1.0), List.of(height(three, "a"), height(three, "b"), height(three, "low")));
        EndedDrags.assertOneStep(before, three);
    }

    @Test
    void facesSelectedByShiftMoveTogetherAlsoAsNewBrushes() {
        ToolScene three = three();
        three.click(TOP, Modifier.SHIFT);
        three.click(new Vec3(-3, 2, 0), Modifier.SHIFT);
        assertEquals(2, three.document().selection().faces().size());
        Level before = three.level();
        three.stroke(TOP, new Vec3(0, 3, 0), Modifier.CONTROL);
        assertEquals(5, three.level().solids().size());
        assertEquals(new Vec3(-3, 2.5, 0), ((Solid.Box) three.solid("b-2")).centre());
        EndedDrags.assertOneStep(before, three);
        three.stroke(new Vec3(3, 1, 0), new Vec3(3, 2, 0));
        assertEquals(2, height(three, "low"));
        assertEquals(2, height(three, "a"), "not selected with the face that moves");
    }

    @Test
    void everyEndButTheReleaseRestores() {
        EndedDrags.restore(scene, TOP, new Vec3(0, 3, 0));
        assertSame(start, scene.level());
    }
}
