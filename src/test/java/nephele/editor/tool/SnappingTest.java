package nephele.editor.tool;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Map;
import java.util.Set;
import nephele.editor.action.ActionCall;
import nephele.editor.action.Actions;
import nephele.editor.document.EntityBounds;
import nephele.editor.pane.PaneKind;
import nephele.editor.text.EditorRefusal;
import nephele.editor.tool.ToolOptions.Snapping;
import nephele.editor.tool.brush.DrawBrushTool;
import nephele.editor.tool.measure.MeasureTool;
import nephele.editor.tool.place.PlaceTool;
import nephele.editor.tool.select.SelectTool;
import nephele.engine.level.Body;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** Each target of snapping in the tools that move, draw, place and measure; the grid's step is half a metre. */
@Execution(ExecutionMode.CONCURRENT)
class SnappingTest {
    /** A cube beside the grid from (-0.8, 0.1, -1) to (0.2, 1.1, 0), and a wall whose corner is at (3.3, 0, 2). */
    private static final String SOLIDS =
            "{\"id\": \"cube\", \"kind\": \"box\", \"centre\": [-0.3, 0.6, -0.5], \"size\": [1, 1, 1]},"
                    + "{\"id\": \"wall\", \"kind\": \"box\", \"centre\": [4.3, 1.1, 1], \"size\": [2, 2.2, 2]}";

    private static ToolScene scene(ToolEntry tool, Snapping... targets) {
        ToolScene scene = ToolScene.of(SOLIDS).using(tool);
        scene.session().options().snapping().clear();
        scene.session().options().snapping().addAll(Set.of(targets));
        return scene;
    }

    private static Aabb bounds(ToolScene scene, String id) {
        return EntityBounds.of((Record) scene.solid(id));
    }

    /** Drags the cube in the plan from above. */
    private static Aabb moved(Vec3 from, Vec3 to, Snapping... targets) {
        ToolScene scene = scene(SelectTool.ENTRY, targets).selecting("cube");
        scene.plan(PaneKind.TOP).stroke(from, to);
        return bounds(scene, "cube");
    }

    @Test
    void movesByStepsOrOntoTheGridOrFreely() {
        Vec3 from = new Vec3(-0.3, 0, -0.5);
        Vec3 to = new Vec3(1.01, 0, -0.5);
        assertEquals(0.7, moved(from, to, Snapping.GRID).minX(), 1e-9);
        Aabb absolute = moved(from, to, Snapping.ABSOLUTE);
        assertEquals(0.5, absolute.minX(), 1e-9);
        assertEquals(0.1, absolute.minY(), 1e-9, "did not move upwards");
        assertEquals(0.51, moved(from, to).minX(), 1e-6);
    }

    @Test
    void aVertexGoesToAVertex() {
        Aabb cube = moved(new Vec3(0.15, 0, -0.05), new Vec3(3.28, 0, 2.03), Snapping.GRID, Snapping.VERTEX);
        assertEquals(3.3, cube.maxX(), 1e-9);
        assertEquals(2, cube.maxZ(), 1e-9);
    }

    @Test
    void whatMovesRestsOnTheSurface() {
        ToolScene scene = scene(SelectTool.ENTRY, Snapping.SURFACE).selecting("cube");
        scene.stroke(new Vec3(-0.3, 1.1, -0.5), new Vec3(4, 2.2, 1));
        assertEquals(2.2, bounds(scene, "cube").minY(), 1e-6);
    }

    @Test
    void brushesAreDrawnFromVerticesAndEdges() {
        ToolScene vertex = scene(DrawBrushTool.ENTRY, Snapping.GRID, Snapping.VERTEX);
        vertex.plan(PaneKind.TOP).stroke(new Vec3(3.27, 0, 2.04), new Vec3(1.1, 0, 3.9));
        assertEquals(3.3, bounds(vertex, "box").maxX(), 1e-9);
        ToolScene edge = scene(DrawBrushTool.ENTRY, Snapping.GRID, Snapping.SURFACE);
        edge.plan(PaneKind.TOP).stroke(new Vec3(3.27, 0, 1.26), new Vec3(1.1, 0, 3.9));
        assertEquals(3.3, bounds(edge, "box").maxX(), 1e-9);
        assertEquals(1, bounds(edge, "box").minX(), 1e-9, "on the grid where no edge is near");
    }

    @Test
    void entitiesArePlacedOnVerticesOrOnTheGrid() {
        ToolScene vertex = scene(PlaceTool.ENTRY, Snapping.VERTEX);
        vertex.click(new Vec3(3.3, 2.2, 2));
        Body.Box body = (Body.Box) vertex.level().bodies().get(0);
        assertEquals(3.3, body.centre().x(), 1e-6);
        ToolScene grid = scene(PlaceTool.ENTRY, Snapping.ABSOLUTE);
        grid.click(new Vec3(4.1, 2.2, 1.1));
        assertEquals(4, ((Body.Box) grid.level().bodies().get(0)).centre().x(), 1e-9);
    }

    @Test
    void theMeasureTakesVerticesAndPlacesOfSurfaces() {
        ToolScene scene = scene(MeasureTool.ENTRY, Snapping.SURFACE);
        scene.stroke(new Vec3(3.3, 2.2, 2), new Vec3(4.31, 2.2, 2));
        assertTrue(
                scene.tool().hint().english().startsWith("1.010 m"),
                scene.tool().hint().english());
    }

    @Test
    void actionsTurnTheTargetsOnAndOff() throws EditorRefusal {
        ToolScene scene = ToolScene.withCube();
        var action = Actions.named("snap-vertex").orElseThrow().effect();
        action.run(new ActionCall(scene.session(), null, Map.of()));
        assertEquals(
                Set.of(Snapping.GRID, Snapping.VERTEX),
                scene.session().options().snapping());
        assertEquals("Snap to Vertices: on", scene.session().status().english());
        action.run(new ActionCall(scene.session(), null, Map.of()));
        assertEquals(Set.of(Snapping.GRID), scene.session().options().snapping());
    }
}
