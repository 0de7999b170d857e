package nephele.editor.action;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.TreeSet;
import nephele.editor.text.EditorRefusal;
import nephele.engine.level.EditorNotes.Group;
import nephele.engine.level.Solid;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What is locked or hidden is left alone, and the pieces of a solid keep its place in the outline. */
@Execution(ExecutionMode.CONCURRENT)
class PieceNotesTest {
    private static final String WALL = "brush box min=0,0,0 max=4,3,0.5 id=wall";
    private static final String HOLE = "brush box min=1,1,-1 max=2,2,2 id=hole";
    private static final String OTHER = "brush box min=4,0,0 max=6,3,0.5 id=other";

    private static Solid wall(ScriptedSession session) {
        return session.level().solids().stream()
                .filter(solid -> solid.id().equals("wall"))
                .findFirst()
                .orElseThrow();
    }

    @ParameterizedTest
    @CsvSource({
        "lock, subtract",
        "hide, subtract",
        "lock, merge",
        "hide, merge",
        "lock, hollow wall=0.1",
        "hide, hollow wall=0.1"
    })
    void brushActionsLeaveLockedAndHiddenSolidsAlone(String away, String action) throws EditorRefusal {
        ScriptedSession session = ScriptedSession.empty().run(WALL);
        Solid before = wall(session);
        session.run(away, OTHER, "brush box min=3,1,-1 max=5,2,2 id=hole");
        if (!action.equals("subtract")) {
            session.run("select ids=solids/wall,solids/other,solids/hole");
        }
        session.run(action);
        assertEquals(before, wall(session));
        assertTrue(session.level().solids().size() != 3, "the others are worked on");
        assertTrue(session.level().editor().locked().size()
                        + session.level().editor().hidden().size()
                == 1);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "subtract",
                "hollow wall=0.1",
                "merge",
                "move by=1,0,0",
                "turn degrees=90",
                "scale by=2,2,2",
                "delete",
                "cut",
                "texture-fit across=3",
                "set portalable to=false"
            })
    void nothingHappensToALockedSolidThatIsSelected(String action) {
        ScriptedSession session =
                ScriptedSession.empty().run(WALL, "lock", OTHER, "lock", "select solids/wall,solids/other");
        String before = session.json();
        assertThrows(EditorRefusal.class, () -> session.script().run(action));
        assertEquals(before, session.json());
    }

    @ParameterizedTest
    @ValueSource(strings = {"lock", "hide"})
    void aCutThatReachesOnlyWhatIsLeftAloneSaysSo(String away) {
        ScriptedSession session = ScriptedSession.empty().run(WALL, away, HOLE, "subtract");
        assertEquals(List.of(wall(session)), session.level().solids());
        assertTrue(session.session().status().english().contains("left alone"));
    }

    @ParameterizedTest
    @CsvSource({"subtract, solids/hole", "hollow wall=0.1, solids/wall"})
    void piecesStayInTheGroupOfTheirSource(String action, String selected) {
        ScriptedSession session = ScriptedSession.empty()
                .run(WALL, OTHER, "select solids/wall,solids/other", "group", HOLE, "select " + selected, action);
        List<Group> groups = session.level().editor().groups();
        TreeSet<String> solids = new TreeSet<>();
        session.level().solids().stream()
                .filter(solid -> !solid.id().equals("hole"))
                .forEach(solid -> solids.add("solids/" + solid.id()));
        assertEquals(1, groups.size());
        assertTrue(solids.size() > 4);
        assertEquals(solids, new TreeSet<>(groups.get(0).members()));
    }

    @Test
    void aMergedSolidIsInTheGroupOfItsFirstSource() {
        ScriptedSession session = ScriptedSession.empty()
                .run(
                        WALL,
                        OTHER,
                        HOLE,
                        "select solids/wall,solids/hole",
                        "group",
                        "select solids/wall,solids/other",
                        "merge");
        assertEquals(
                List.of("solids/wall", "solids/hole"),
                session.level().editor().groups().get(0).members());
    }

    @Test
    void copiesOfAGroupAreAGroupOfTheirOwn() {
        ScriptedSession session = ScriptedSession.empty()
                .run(WALL, OTHER, "select solids/wall,solids/other", "group", "duplicate", "copy", "cut", "paste");
        List<Group> groups = session.level().editor().groups();
        assertEquals(List.of("solids/wall", "solids/other"), groups.get(0).members());
        assertEquals(2, groups.size());
        assertEquals(List.of("solids/wall-2", "solids/other-2"), groups.get(1).members());
    }
}
