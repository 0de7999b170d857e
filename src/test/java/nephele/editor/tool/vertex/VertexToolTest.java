package nephele.editor.tool.vertex;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.editor.brush.BrushText;
import nephele.editor.pane.Mark;
import nephele.editor.pane.MarkColour;
import nephele.editor.pane.PaneKind;
import nephele.editor.tool.EndedDrags;
import nephele.editor.tool.Pointer.Modifier;
import nephele.editor.tool.ToolScene;
import nephele.engine.level.Brush;
import nephele.engine.level.Level;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** Vertices and edges follow the pointer by steps while the brush stays convex. */
@Execution(ExecutionMode.CONCURRENT)
class VertexToolTest {
    private static final Vec3 CORNER = new Vec3(1, 2, 1);

    private final ToolScene scene = ToolScene.withCube().using(VertexTool.ENTRY).selecting("cube");
    private final Level start = scene.level();

    private long handles(MarkColour colour) {
        return scene.tool().marks().stream()
                .filter(mark -> mark instanceof Mark.Handle && mark.colour() == colour)
                .count();
    }

    @Test
    void aVertexMovesAndStaysSelected() {
        assertEquals(20, scene.tool().marks().size());
        scene.stroke(CORNER, new Vec3(1.6, 2, 1.1));
        assertTrue(scene.hasVertices("cube", new Vec3(1.5, 2, 1), new Vec3(1, 2, -1)));
        assertEquals(8, Brush.of(scene.solid("cube")).shape().vertices().size());
        assertEquals(1, handles(MarkColour.SELECTED));
        EndedDrags.assertOneStep(start, scene);
    }

    @Test
    void anEdgeMovesByItsMiddle() {
        scene.stroke(new Vec3(0, 2, 1), new Vec3(0, 2, 2.1));
        assertTrue(scene.hasVertices("cube", new Vec3(-1, 2, 2), new Vec3(1, 2, 2)));
    }

    @Test
    void controlSplitsAnEdgeInItsMiddle() {
        scene.press(new Vec3(0, 2, 1), Modifier.CONTROL);
        scene.drag(new Vec3(0, 2, 2.1), Modifier.CONTROL);
        scene.release(new Vec3(0, 2, 2.1));
        assertEquals(9, Brush.of(scene.solid("cube")).shape().vertices().size());
        assertTrue(scene.hasVertices("cube", new Vec3(0, 2, 2), new Vec3(-1, 2, 1), new Vec3(1, 2, 1)));
        EndedDrags.assertOneStep(start, scene);
    }

    @Test
    void shiftAddsAndRemovesAndAltMovesVertically() {
        scene.click(CORNER);
        scene.click(new Vec3(1, 2, -1), Modifier.SHIFT);
        scene.click(new Vec3(-1, 2, 1), Modifier.SHIFT);
        scene.click(new Vec3(-1, 2, 1), Modifier.SHIFT);
        assertEquals(2, handles(MarkColour.SELECTED));
        scene.press(CORNER);
        scene.drag(new Vec3(1, 3.1, 1), Modifier.ALT);
        scene.release(new Vec3(1, 3.1, 1));
        assertTrue(scene.hasVertices("cube", new Vec3(1, 3, 1), new Vec3(1, 3, -1)));
        assertTrue(scene.hasVertices("cube", new Vec3(-1, 2, 1)));
    }

    @Test
    void aRefusalIsShownAndChangesNothing() {
        ToolScene plan = scene.plan(PaneKind.TOP);
        plan.stroke(CORNER, new Vec3(-0.5, 2, -0.5));
        assertSame(start, scene.level());
        assertEquals(BrushText.VERTEX_VANISHES.words(), scene.session().status());
    }

    @Test
    void verticesOfSeveralBrushesAtOnePlaceMoveTogether() {
        ToolScene two = ToolScene.of("{\"id\": \"a\", \"kind\": \"box\", \"centre\": [0, 1, 0], \"size\": [2, 2, 2]},"
                        + "{\"id\": \"b\", \"kind\": \"box\", \"centre\": [2, 1, 0], \"size\": [2, 2, 2]}")
                .using(VertexTool.ENTRY)
                .selecting("a", "b");
        two.stroke(CORNER, new Vec3(1, 2, 2.1));
        two.stroke(new Vec3(1, 2, 2), new Vec3(1, 2, 2.5));
        assertTrue(two.hasVertices("a", new Vec3(1, 2, 2.5)));
        assertTrue(two.hasVertices("b", new Vec3(1, 2, 2.5)));
    }

    @Test
    void elsewhereThePointerSelects() {
        scene.click(new Vec3(6, 0, 0));
        assertTrue(scene.document().selection().isEmpty());
        assertTrue(scene.tool().marks().isEmpty());
    }

    @Test
    void everyEndButTheReleaseRestores() {
        EndedDrags.restore(scene, CORNER, new Vec3(2, 2, 2));
        assertSame(start, scene.level());
    }
}
