package nephele.editor.action;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import nephele.editor.pane.Mark;
import nephele.editor.problem.LevelProblem;
import nephele.editor.proving.HeatText;
import nephele.editor.proving.Proving;
import nephele.editor.record.EntityRef;
import nephele.editor.save.DocumentFile;
import nephele.editor.session.EditorSession;
import nephele.editor.session.EditorSettings;
import nephele.editor.text.EditorRefusal;
import nephele.engine.level.Language;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** The proofs of a level, from a script: no window, everything at once. */
@Execution(ExecutionMode.CONCURRENT)
class ProvingActionsTest {
    private static final String ROOM = "brush room min=-4,0,-4 max=4,4,4 wall=0.5 id=wall";

    /** Returns a room with a lamp that lights nothing and a box of no use to a portal. */
    private static ScriptedSession room() {
        return ScriptedSession.empty().run(ROOM, "add player at=0,0.5,0", "add lights.point at=0,60,0 id=far");
    }

    private static String wall(ScriptedSession room) {
        return "solids/" + room.level().solids().get(0).id();
    }

    private static Proving proving(ScriptedSession session) {
        return session.session().proving();
    }

    private static ScriptedSession opened(String level) {
        DocumentFile.Opened opened = DocumentFile.open(level);
        EditorSession session =
                new EditorSession(opened.file(), opened.level(), opened.assets(), EditorSettings.DEFAULT);
        return new ScriptedSession(
                session,
                new ScriptRunner(session, new ScriptInterface(() -> new java.awt.image.BufferedImage(4, 4, 1))));
    }

    @Test
    void problemsAreVisitedInTurnAndMarkedUntilAnotherSelection() {
        ScriptedSession room = room();
        List<LevelProblem> problems = proving(room).problems().listed();
        assertTrue(problems.size() >= 2, problems.toString());
        for (LevelProblem problem : problems) {
            room.run("next-problem");
            assertEquals(problem, proving(room).problems().chosen().orElseThrow());
            assertEquals(problem.marks(), proving(room).marks());
        }
        room.run("next-problem", "previous-problem");
        assertEquals(
                problems.get(problems.size() - 1),
                proving(room).problems().chosen().orElseThrow());
        LevelProblem marked = problems.stream()
                .filter(problem -> !problem.marks().isEmpty())
                .findFirst()
                .orElseThrow();
        ProvingActions.choose(room.session(), marked);
        room.run("select " + wall(room));
        assertTrue(proving(room).marks().isEmpty());
        ProvingActions.choose(room.session(), marked);
        room.run("cancel");
        assertTrue(proving(room).marks().isEmpty());
    }

    @Test
    void theCameraLooksAtTheProblem() {
        ScriptedSession room = room();
        LevelProblem lamp = proving(room).problems().listed().stream()
                .filter(problem -> new EntityRef("lights", "far").equals(problem.entity()))
                .findFirst()
                .orElseThrow();
        ProvingActions.choose(room.session(), lamp);
        var eye = room.session().panes().views().get(0).perspective();
        assertTrue(eye.eye().y() > 30, eye.toString());
        assertEquals(
                "far", room.session().document().selection().entities().get(0).id());
    }

    @Test
    void aCheckFailsAtTheFirstError() {
        ScriptedSession room = room();
        room.run("check");
        assertTrue(room.session().status().english().startsWith("Problems: 0 errors"));
        room.run("brush box min=1,1,1 max=2,2,2 id=crate", "add player at=1.5,1,1.5");
        EditorRefusal failure =
                assertThrows(EditorRefusal.class, () -> room.script().run("check"));
        assertTrue(failure.getMessage().contains("player"), failure.getMessage());
    }

    @Test
    void theHeatMapFollowsEdits() {
        ScriptedSession room = room().run("heat");
        int before = proving(room).heat().counts().get(HeatText.FITS);
        List<Mark> marks = proving(room).heat().marks();
        room.run("select " + wall(room), "set portalable to=false");
        assertTrue(proving(room).heat().counts().get(HeatText.FITS) < before);
        room.run("undo");
        assertEquals(marks, proving(room).heat().marks());
        room.run("heat show=false");
        assertTrue(proving(room).heat().marks().isEmpty());
    }

    @Test
    void theTracedPictureHasTheSamplesAskedFor() {
        ScriptedSession room = room().run("path-trace show=true spp=3");
        var traced = proving(room).corner().traced().orElseThrow();
        assertEquals(3, traced.samples());
        room.run("camera at=0,1,3 yaw=90");
        assertFalse(java.util.Arrays.equals(
                traced.picture().samples(),
                proving(room).corner().traced().orElseThrow().picture().samples()));
        room.run("path-trace");
        assertTrue(proving(room).corner().traced().isEmpty());
    }

    @Test
    void anExplanationNamesSurfaceLightAndPasses(@TempDir Path folder) throws Exception {
        Path file = folder.resolve("pixel.txt");
        room().run("camera at=0,1.5,3 yaw=0 pitch=0", "explain file=" + file + " at=0,1.5,-3.5");
        String text = Files.readString(file);
        assertTrue(text.contains("Sees: solids/wall-"), text);
        assertTrue(text.contains("Traced radiance: "), text);
        assertTrue(text.contains("\n  solid: required by solids"), text);
    }

    @Test
    void aSolutionIsCheckedInTheLevelAsItIs() {
        ScriptedSession level = opened("levels/02-first-shot.json");
        level.run("check-solution");
        String said = level.session().status().in(Language.EN);
        assertTrue(said.startsWith("Solved at tick "), said);
        level.run("select-all", "delete");
        assertThrows(EditorRefusal.class, () -> level.script().run("check-solution"));
        assertFalse(proving(level).marks().isEmpty());
        level.run("undo");
        assertTrue(proving(level).marks().isEmpty());
    }

    @Test
    void withoutAFileThereIsNoSolutionAndNoReport() {
        ScriptedSession room = room();
        for (String line : List.of("check-solution", "trade")) {
            EditorRefusal failure =
                    assertThrows(EditorRefusal.class, () -> room.script().run(line));
            assertTrue(failure.getMessage().startsWith("save the level first: "), failure.getMessage());
        }
    }
}
