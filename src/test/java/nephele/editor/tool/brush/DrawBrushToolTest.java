package nephele.editor.tool.brush;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.util.List;
import nephele.editor.brush.ShapeOptions;
import nephele.editor.pane.PaneKind;
import nephele.editor.record.EntityRef;
import nephele.editor.tool.EndedDrags;
import nephele.editor.tool.Pointer.Modifier;
import nephele.editor.tool.ToolScene;
import nephele.engine.level.Level;
import nephele.engine.level.Solid;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** A drag draws exactly the snapped box, in one step. */
@Execution(ExecutionMode.CONCURRENT)
class DrawBrushToolTest {
    private final ToolScene scene = ToolScene.withCube().using(DrawBrushTool.ENTRY);
    private final Level start = scene.level();

    @Test
    void drawsOnAFaceWithTheOptions() {
        scene.session().options().material("red");
        scene.session().options().portalable(false);
        scene.stroke(new Vec3(-0.52, 2, -0.51), new Vec3(0.48, 2, 0.97));
        scene.assertBox("box", new Vec3(0, 2.5, 0.25), new Vec3(1, 1, 1.5));
        assertEquals("red", scene.solid("box").material());
        assertFalse(scene.solid("box").portalable());
        assertEquals(
                List.of(new EntityRef("solids", "box")),
                scene.document().selection().entities());
        EndedDrags.assertOneStep(start, scene);
    }

    @Test
    void drawsOnTheFloorWhereNothingIs() {
        scene.session().options().material("missing");
        scene.stroke(new Vec3(2, 0, 1), new Vec3(3, 0, 2));
        scene.assertBox("box", new Vec3(2.5, 0.5, 1.5), new Vec3(1, 1, 1));
        assertNull(scene.solid("box").material());
    }

    @Test
    void drawsOnASideOutwards() {
        scene.stroke(new Vec3(-0.5, 0.5, 1), new Vec3(0.5, 1.5, 1));
        scene.assertBox("box", new Vec3(0, 1, 1.5), new Vec3(1, 1, 1));
    }

    @Test
    void altChangesTheHeightAndShiftMakesTheBaseSquare() {
        scene.press(new Vec3(2, 0, 1));
        scene.drag(new Vec3(4, 0, 2), Modifier.SHIFT);
        scene.drag(new Vec3(4, 2.9, 3), Modifier.ALT);
        scene.release(new Vec3(4, 2.9, 3));
        scene.assertBox("box", new Vec3(3, 1.5, 2), new Vec3(2, 3, 2));
    }

    @Test
    void aPlanTakesTheDepthOfTheSelectionOrOneStep() {
        ToolScene plan = scene.plan(PaneKind.TOP);
        plan.stroke(new Vec3(2, 0, 0), new Vec3(3, 0, 1));
        scene.assertBox("box", new Vec3(2.5, 0.25, 0.5), new Vec3(1, 0.5, 1));
        plan.selecting("cube").using(DrawBrushTool.ENTRY);
        plan.stroke(new Vec3(-2, 0, 0), new Vec3(-3, 0, 1));
        scene.assertBox("box-2", new Vec3(-2.5, 1, 0.5), new Vec3(1, 2, 1));
    }

    @Test
    void otherShapesAreSeveralSolidsWithTheirOwnIds() {
        scene.session().options().shape(new ShapeOptions.Stairs(null, 4));
        scene.stroke(new Vec3(2, 0, 1), new Vec3(4, 0, 2));
        assertEquals(
                List.of("cube", "stairs", "stairs-2", "stairs-3", "stairs-4"),
                scene.level().solids().stream().map(Solid::id).toList());
        EndedDrags.assertOneStep(start, scene);
    }

    @Test
    void aFlatDragOrAClickDrawsNothing() {
        scene.stroke(new Vec3(2, 0, 1), new Vec3(4, 0, 1.1));
        scene.click(new Vec3(2, 0, 1));
        assertSame(start, scene.level());
    }

    @Test
    void everyEndButTheReleaseRestores() {
        EndedDrags.restore(scene, new Vec3(2, 0, 1), new Vec3(4, 0, 2));
        assertSame(start, scene.level());
    }
}
