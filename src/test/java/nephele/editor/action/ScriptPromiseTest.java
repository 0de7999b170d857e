package nephele.editor.action;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import nephele.editor.action.EditorAction.Subject;
import nephele.editor.text.EditorRefusal;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** A line of a script either does what its action is there for, or fails and says why. */
@Execution(ExecutionMode.CONCURRENT)
class ScriptPromiseTest {
    private static final String BOX = "brush box min=0,0,0 max=1,1,1 id=block";
    private static final String LAMP = "add lights.point at=5,0,0 id=lamp";
    private static final String NOTHING = "changed nothing";

    /** Lines that succeed, then one that has nothing to do, and what it says. */
    private record Idle(List<String> before, String line, String said) {
        static Idle of(String... all) {
            List<String> lines = Arrays.asList(all);
            return new Idle(
                    lines.subList(0, lines.size() - 2), lines.get(lines.size() - 2), lines.get(lines.size() - 1));
        }

        String action() {
            return line.split(" ")[0];
        }

        @Override
        public String toString() {
            return line;
        }
    }

    static Stream<Idle> idle() {
        return Stream.of(
                Idle.of(BOX, "scale by=0,1,1", "must not have a 0"),
                Idle.of(BOX, "scale by=1e-9,1,1", ""),
                Idle.of(BOX, "scale by=1e300,1,1", ""),
                Idle.of(BOX, "scale by=1,1,1", NOTHING),
                Idle.of(BOX, LAMP, "select-all", "scale by=1e-9,1,1", ""),
                Idle.of("add materials id=brick", "scale by=2,2,2", NOTHING),
                Idle.of(BOX, "turn axis=0,0,0 degrees=45", "axis must not be 0,0,0"),
                Idle.of(BOX, "turn degrees=0", NOTHING),
                Idle.of(LAMP, "turn axis=0,0,0", "axis must not be 0,0,0"),
                Idle.of(LAMP, "turn degrees=360 pivot=0,0,0", NOTHING),
                Idle.of(BOX, "move by=0,0,0", NOTHING),
                Idle.of(BOX, "move by=1e-300,0,0", NOTHING),
                Idle.of(LAMP, "set rangeMetres to=12", "set rangeMetres to=12", NOTHING),
                Idle.of("add", "kind is missing"),
                Idle.of(BOX, "rename id=block", NOTHING),
                Idle.of(BOX, "rename", "id is missing"),
                Idle.of(BOX, "hide", "select solids/block", "hide", NOTHING),
                Idle.of(BOX, LAMP, "isolate", "select lights/lamp", "isolate", NOTHING),
                Idle.of(BOX, "isolate", NOTHING),
                Idle.of(BOX, "show-all", NOTHING),
                Idle.of(BOX, "lock", "select solids/block", "lock", NOTHING),
                Idle.of(BOX, "unlock-all", NOTHING),
                Idle.of(BOX, LAMP, "select-all", "group", "group", NOTHING),
                Idle.of(BOX, "ungroup", NOTHING),
                Idle.of(BOX, "subtract", "nothing to cut"),
                Idle.of(BOX, "brush box min=3,0,0 max=4,1,1", "subtract", "nothing to cut"),
                Idle.of(BOX, "merge", ""),
                Idle.of(BOX, "hollow wall=5", ""),
                Idle.of("brush box min=0,0,0 max=0,1,1", ""),
                Idle.of(BOX, "texture-reset", NOTHING),
                Idle.of(BOX, "texture-fit across=3", "texture-fit across=3", NOTHING),
                Idle.of(BOX, "texture-left", NOTHING),
                Idle.of(BOX, "texture-centre", NOTHING),
                Idle.of(BOX, "texture-right", NOTHING),
                Idle.of(BOX, "texture-top", NOTHING),
                Idle.of(BOX, "texture-middle", NOTHING),
                Idle.of(BOX, "texture-bottom", NOTHING),
                Idle.of("paste", "no entities"),
                Idle.of("add player at=0,0,0", "duplicate", "can't be copied"),
                Idle.of("add player at=0,0,0", "cut", "can't be copied"),
                Idle.of(BOX, "select-none", "delete", "not possible now"),
                Idle.of("undo", "not possible now"),
                Idle.of("redo", "not possible now"),
                Idle.of("backups restore=1", "not possible now"),
                Idle.of("terrain-stroke effect=raise from=0,0,0", "not possible now"));
    }

    @ParameterizedTest
    @MethodSource("idle")
    void aLineThatChangesNothingFailsAndAddsNoStep(Idle idle) {
        ScriptedSession session = ScriptedSession.empty().run(idle.before().toArray(String[]::new));
        String before = session.json();
        int steps = session.session().document().history().position();
        EditorRefusal failure =
                assertThrows(EditorRefusal.class, () -> session.script().run(idle.line()));
        assertTrue(failure.getMessage().contains(idle.said()), failure.getMessage());
        assertEquals(before, session.json());
        assertEquals(steps, session.session().document().history().position());
    }

    @Test
    void everyActionThatChangesLevelsIsTriedWithNothingToDo() {
        assertEquals(ids(Subject.LEVEL), idle().map(Idle::action).collect(Collectors.toCollection(TreeSet::new)));
    }

    private static Set<String> ids(Subject subject) {
        return Actions.ALL.stream()
                .filter(action -> action.subject() == subject)
                .map(EditorAction::id)
                .collect(Collectors.toCollection(TreeSet::new));
    }

    /** Also finds an action that changes levels and does not declare it. */
    @Test
    void allOtherActionsLeaveTheLevelAsItIs() {
        for (EditorAction action : Actions.ALL) {
            if (action.subject() != Subject.LEVEL && !action.id().equals("new")) {
                ScriptedSession session = ScriptedSession.empty().run(BOX, LAMP, "select-all");
                String before = session.json();
                try {
                    session.script().run(action.id());
                    assertEquals(Subject.SESSION, action.subject(), action.id() + " needs a window");
                } catch (EditorRefusal refused) {
                    // It needs a value, a file or a window, and said so.
                }
                assertEquals(before, session.json(), action.id());
            }
        }
    }

    @ParameterizedTest
    @MethodSource("unanswered")
    void whatOnlyAUserCouldAnswerFails(String line) {
        ScriptedSession session = ScriptedSession.empty().run(BOX);
        assertThrows(EditorRefusal.class, () -> session.script().run(line));
    }

    static Stream<String> unanswered() {
        return Stream.of(
                "save",
                "save-as",
                "open",
                "open-recent",
                "export",
                "screenshot",
                "select",
                "camera",
                "explain",
                "explain at=0,0,0",
                "settings",
                "turn-by",
                "guide",
                "palette",
                "keys",
                "play-here",
                "play-start",
                "recover",
                "heat show=maybe",
                "move by=1,0,0 by=2,0,0");
    }

    @Test
    void quitEndsTheScript() throws EditorRefusal {
        ScriptInterface ui = new ScriptInterface(() -> null);
        new ScriptRunner(ScriptedSession.empty().session(), ui).run("quit");
        assertTrue(ui.isEnded());
    }
}
