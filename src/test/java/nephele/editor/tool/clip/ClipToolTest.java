package nephele.editor.tool.clip;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import nephele.editor.action.ActionCall;
import nephele.editor.action.Actions;
import nephele.editor.brush.BrushText;
import nephele.editor.pane.Mark;
import nephele.editor.pane.MarkColour;
import nephele.editor.pane.PaneKind;
import nephele.editor.text.EditorRefusal;
import nephele.editor.tool.EndedDrags;
import nephele.editor.tool.Pointer.Modifier;
import nephele.editor.tool.ToolScene;
import nephele.editor.tool.select.SelectTool;
import nephele.engine.level.Brush;
import nephele.engine.level.Level;
import nephele.engine.level.Solid;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** Points give a plane; Enter cuts by it in one step, and nothing changes before. */
@Execution(ExecutionMode.CONCURRENT)
class ClipToolTest {
    private final ToolScene scene = ToolScene.withCube().using(ClipTool.ENTRY);
    private final ToolScene plan = scene.plan(PaneKind.TOP);
    private final Level start = scene.level();

    private Aabb bounds(String id) {
        return Brush.of(scene.solid(id)).shape().bounds();
    }

    private void cutAcross() {
        plan.click(new Vec3(0.52, 0, 2));
        plan.stroke(new Vec3(3, 0, 3), new Vec3(0.48, 0, -2));
    }

    private List<String> ids() {
        return scene.level().solids().stream().map(Solid::id).toList();
    }

    @Test
    void twoPointsOfAPlanCutAndKeepOnePart() {
        cutAcross();
        assertSame(start, scene.level());
        assertTrue(scene.tool().confirm());
        Aabb kept = bounds("cube");
        assertEquals(List.of("cube"), ids());
        assertTrue(kept.minX() == 0.5 || kept.maxX() == 0.5, kept.toString());
        EndedDrags.assertOneStep(start, scene);
        assertFalse(scene.tool().confirm(), "the points are used");
    }

    @Test
    void controlClicksChooseTheOtherPartAndBoth() {
        cutAcross();
        scene.tool().confirm();
        Aabb first = bounds("cube");
        scene.document().undo();
        cutAcross();
        plan.click(new Vec3(3, 0, 3), Modifier.CONTROL);
        scene.tool().confirm();
        Aabb second = bounds("cube");
        assertEquals(2, first.maxX() - first.minX() + second.maxX() - second.minX());
        scene.document().undo();
        scene.selecting("cube");
        cutAcross();
        plan.click(new Vec3(3, 0, 3), Modifier.CONTROL);
        scene.tool().confirm();
        assertEquals(List.of("cube", "cube-2"), ids());
        assertEquals(2, scene.document().selection().entities().size());
    }

    @Test
    void threePointsOfThePerspectiveViewGiveAnObliquePlane() {
        scene.click(new Vec3(-0.5, 1, 1));
        scene.click(new Vec3(0.5, 1, 1));
        assertFalse(scene.tool().confirm());
        scene.click(new Vec3(0.5, 0.5, 1));
        assertTrue(scene.tool().confirm());
        assertEquals(BrushText.PLANE_MISSES.words(), scene.session().status());
        assertSame(start, scene.level());
        scene.stroke(new Vec3(0.5, 0.5, 1), new Vec3(0.5, 2, 0));
        assertTrue(scene.tool().confirm());
        assertTrue(scene.hasVertices("cube", new Vec3(1, 2, 0), new Vec3(1, 1, 1)));
        EndedDrags.assertOneStep(start, scene);
    }

    @Test
    void aDoubleClickTakesThePlaneOfAFace() {
        ToolScene two = ToolScene.of(
                        "{\"id\": \"low\", \"kind\": \"box\", \"centre\": [0, 0.5, 0], \"size\": [2, 1, 2]},"
                                + "{\"id\": \"high\", \"kind\": \"box\", \"centre\": [-3, 2, 0], \"size\": [2, 4, 2]}")
                .using(ClipTool.ENTRY)
                .selecting("high");
        two.doubleClick(new Vec3(0.2, 1, 0.3));
        assertTrue(two.tool().confirm());
        assertEquals(new Vec3(2, 1, 2), ((Solid.Box) two.solid("high")).size());
    }

    @Test
    void theActionChoosesThePartAndTheHintNamesIt() throws EditorRefusal {
        cutAcross();
        String behind = scene.tool().hint().english();
        Actions.named("clip-keep").orElseThrow().effect().run(new ActionCall(scene.session(), null, Map.of()));
        assertNotEquals(behind, scene.tool().hint().english());
        assertTrue(scene.tool().hint().english().contains("in front"));
        scene.session().use(SelectTool.ENTRY);
        assertFalse(Actions.named("clip-keep").orElseThrow().isEnabled().test(scene.session()));
    }

    @Test
    void bothPartsAreShown() {
        cutAcross();
        List<MarkColour> colours =
                scene.tool().marks().stream().map(Mark::colour).distinct().toList();
        assertTrue(colours.containsAll(List.of(MarkColour.PREVIEW, MarkColour.REFUSED)));
    }

    @Test
    void onlySelectedBrushesAreCut() {
        ToolScene two = ToolScene.of("{\"id\": \"a\", \"kind\": \"box\", \"centre\": [0, 1, 0], \"size\": [2, 2, 2]},"
                        + "{\"id\": \"b\", \"kind\": \"box\", \"centre\": [0, 5, 0], \"size\": [2, 2, 2]}")
                .using(ClipTool.ENTRY)
                .selecting("b")
                .plan(PaneKind.TOP);
        Solid untouched = two.solid("a");
        two.click(new Vec3(0, 0, 2));
        two.click(new Vec3(0, 0, -2));
        two.tool().confirm();
        assertSame(untouched, two.solid("a"));
        assertEquals(new Vec3(1, 2, 2), ((Solid.Box) two.solid("b")).size());
    }

    @Test
    void escapeAndAnotherToolForgetThePoints() {
        cutAcross();
        scene.tool().cancel();
        assertTrue(scene.tool().marks().isEmpty());
        assertFalse(scene.tool().confirm());
        cutAcross();
        scene.session().use(SelectTool.ENTRY);
        assertSame(start, scene.level());
    }
}
