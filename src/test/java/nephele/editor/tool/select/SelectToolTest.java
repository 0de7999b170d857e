package nephele.editor.tool.select;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.util.List;
import java.util.Set;
import nephele.editor.action.ScriptedSession;
import nephele.editor.pane.PaneCamera.PaneSize;
import nephele.editor.pane.PaneKind;
import nephele.editor.pane.PlanCamera;
import nephele.editor.record.EntityRef;
import nephele.editor.session.Tools;
import nephele.editor.tool.Pointer;
import nephele.editor.tool.Pointer.Modifier;
import nephele.editor.tool.Tool;
import nephele.engine.level.Level;
import nephele.engine.level.Solid;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** Events in a plan from above, where a pixel is a centimetre and the middle of the picture is the origin. */
@Execution(ExecutionMode.CONCURRENT)
class SelectToolTest {
    private static final PaneSize SIZE = new PaneSize(800, 600);

    private final ScriptedSession session = ScriptedSession.empty()
            .run(
                    "brush box min=-1,0,-1 max=1,1,1 id=low",
                    "brush box min=-0.5,2,-0.5 max=0.5,3,0.5 id=high",
                    "brush box min=2,0,-1 max=3,1,1 id=beside",
                    "select-none");
    private final Tool tool = session.session().tool();

    private static Pointer at(double xMetres, double zMetres, Modifier... held) {
        PlanCamera camera = new PlanCamera(PaneKind.TOP, Vec3.ZERO, 0.01);
        return new Pointer(PaneKind.TOP, camera, SIZE, 400 + 100 * xMetres, 300 + 100 * zMetres, Set.of(held), 1);
    }

    private void drag(Pointer from, Pointer... to) {
        tool.pressed(from);
        for (Pointer pointer : to) {
            tool.dragged(pointer);
        }
        tool.released(to[to.length - 1]);
    }

    private List<String> selected() {
        return session.session().document().selection().entities().stream()
                .map(EntityRef::id)
                .toList();
    }

    private void click(Pointer pointer) {
        tool.pressed(pointer);
        tool.released(pointer);
    }

    @Test
    void aDragOverSelectedGroundMovesNothingAndSelectsWhatStandsOnIt() {
        session.run("add terrains at=0,-90,0 id=ground", "add environment.clouds at=0,-40,0 id=cloud");
        session.run("select terrains/ground");
        String before = session.json();
        drag(at(1.8, -2), at(2.2, -1.5), at(3.2, 1.5));
        assertEquals(before, session.json());
        assertEquals(List.of("beside"), selected());
    }

    @Test
    void aClickTakesTheNearestAndAnotherTheNextBehindIt() {
        click(at(0, 0));
        assertEquals(List.of("high"), selected());
        click(at(0, 0));
        assertEquals(List.of("low"), selected());
        click(at(0, 0));
        assertEquals(List.of("high"), selected());
        click(at(3.9, 0));
        assertEquals(List.of(), selected());
    }

    @Test
    void shiftAddsAndTakesAway() {
        click(at(0.8, 0));
        click(at(2.5, 0, Modifier.SHIFT));
        assertEquals(List.of("low", "beside"), selected());
        click(at(0.8, 0, Modifier.SHIFT));
        assertEquals(List.of("beside"), selected());
    }

    @Test
    void aRectangleTakesWhatItTouchesOrWhatIsInside() {
        drag(at(-3, -2), at(2.5, 2));
        assertEquals(Set.of("low", "high", "beside"), Set.copyOf(selected()));
        drag(at(-3, -2, Modifier.ALT), at(2.5, 2, Modifier.ALT));
        assertEquals(Set.of("low", "high"), Set.copyOf(selected()));
    }

    @Test
    void aDragMovesWhatIsSelectedOnTheGridAsOneStep() {
        click(at(2.5, 0));
        int before = session.session().document().history().position();
        drag(at(2.5, 0), at(2.7, 0.2), at(3.52, 0.98));
        Solid.Box moved = (Solid.Box) session.level().solids().get(2);
        assertEquals(new Vec3(3.5, 0.5, 1), moved.centre());
        assertEquals(before + 1, session.session().document().history().position());
        session.run("undo");
        assertEquals(
                new Vec3(2.5, 0.5, 0), ((Solid.Box) session.level().solids().get(2)).centre());
    }

    @Test
    void escapeAndAnotherToolGiveExactlyTheLevelBefore() {
        click(at(2.5, 0));
        Level before = session.level();
        tool.pressed(at(2.5, 0));
        tool.dragged(at(3.5, 1));
        tool.cancel();
        assertSame(before, session.level());
        tool.pressed(at(2.5, 0));
        tool.dragged(at(3.5, 1));
        session.session().use(Tools.ALL.get(0));
        assertSame(before, session.level());
        tool.released(at(3.5, 1));
        assertSame(before, session.level());
    }

    @Test
    void lockedAndHiddenEntitiesAreNotTaken() {
        session.run("select ids=solids/high", "lock", "select ids=solids/beside", "hide");
        click(at(0, 0));
        assertEquals(List.of("low"), selected());
        click(at(2.5, 0));
        assertEquals(List.of(), selected());
    }

    @Test
    void aGroupIsTakenAsAWhole() {
        session.run("select ids=solids/low,solids/beside", "group", "select-none");
        click(at(2.5, 0));
        assertEquals(Set.of("low", "beside"), Set.copyOf(selected()));
    }
}
