package nephele.editor.action;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import nephele.editor.brush.SolidTransform;
import nephele.editor.record.EntityRef;
import nephele.editor.text.EditorRefusal;
import nephele.editor.text.Words;
import nephele.engine.level.Light;
import nephele.engine.level.Solid;
import nephele.engine.level.json.LevelFile;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

@Execution(ExecutionMode.CONCURRENT)
class ScriptRunnerTest {
    @Test
    void aScriptBuildsARoom() {
        ScriptedSession room = ScriptedSession.empty()
                .run(
                        "# a room with what a level needs",
                        "brush room min=-4,0,-4 max=4,4,4 wall=0.5 id=wall",
                        "add lights.point at=0,3,0 id=lamp",
                        "set rangeMetres to=12",
                        "add bodies.box at=1,0.8,1",
                        "add environment.clouds at=0,60,0",
                        "add exits at=2,0.5,2",
                        "add player at=0,0.5,0");
        assertEquals(6, room.level().solids().size());
        assertEquals(12, ((Light.Point) room.level().lights().get(0)).rangeMetres());
        assertEquals("lamp", room.level().lights().get(0).id());
        assertEquals(new Vec3(0, 0.5, 0), room.level().player().feet());
        assertEquals(
                List.of(EntityRef.single("player")),
                room.session().document().selection().entities());
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "fly away | there is no action 'fly'",
                "add kind=cheese | there is no kind 'cheese'",
                "brush box min=1,2 max=3,3,3 | min must be three numbers",
                "brush box max=3,3,3 | min is missing",
                "brush cube min=0,0,0 max=1,1,1 | there is no shape 'cube'",
                "move by=1,0,0 | move is not possible now",
                "select ids=solids/none | the level has no 'solids/none'",
                "undo | undo is not possible now",
                "grid metres=NaN | metres must be a number",
                "grid feet=3 | grid has no 'feet=3'",
                "select \"ids | a \" is missing",
                "save file=/no/such/room.json | is missing: nothing was saved"
            })
    void aLineThatCannotBeDoneSaysWhyAndChangesNothing(String line, String said) {
        ScriptedSession session = ScriptedSession.empty();
        String before = session.json();
        EditorRefusal failure =
                assertThrows(EditorRefusal.class, () -> session.script().run(line));
        assertTrue(failure.getMessage().contains(said), failure.getMessage());
        assertEquals(before, session.json());
    }

    @Test
    void brushesAreHollowedCutAndMerged() {
        ScriptedSession session =
                ScriptedSession.empty().run("brush box min=0,0,0 max=4,4,4 id=block", "hollow wall=0.5");
        assertEquals(6, session.level().solids().size());
        session.run("undo");
        assertEquals(1, session.level().solids().size());
        session.run("brush box min=1,1,-1 max=2,2,5 id=cutter", "subtract");
        assertEquals(4, session.level().solids().size());
        session.run("undo", "undo", "undo");
        assertEquals(0, session.level().solids().size());
        session.run("brush box min=0,0,0 max=1,1,1", "brush box min=1,0,0 max=2,1,1", "select-all", "merge");
        assertEquals(new Vec3(2, 1, 1), ((Solid.Box) session.level().solids().get(0)).size());
    }

    @Test
    void anActionDuringADragBeginsWithTheStateBeforeIt() {
        ScriptedSession session = ScriptedSession.empty()
                .run("brush box min=0,0,0 max=4,4,4 id=block", "brush box min=1,1,-1 max=2,2,5 id=cutter");
        session.session()
                .document()
                .drag(before -> before.with(before.level()
                        .with(
                                before.level().materials(),
                                before.level().solids().stream()
                                        .map(solid -> SolidTransform.moved(solid, new Vec3(0, 0, 9)))
                                        .toList())));
        session.run("subtract");
        assertEquals(4, session.level().solids().size());
    }

    @Test
    void copiesCarryTheirReferencesAndMaterials() {
        ScriptedSession session = ScriptedSession.empty()
                .run(
                        "add portals at=0,1,0 id=a",
                        "set linkedTo to=b",
                        "add portals at=5,1,0 id=b",
                        "set linkedTo to=a",
                        "select ids=portals/a,portals/b",
                        "copy",
                        "paste by=0,0,9");
        assertEquals(
                List.of("a->b", "b->a", "a-2->b-2", "b-2->a-2"),
                session.level().portals().stream()
                        .map(portal -> portal.id() + "->" + portal.linkedTo())
                        .toList());
        assertEquals(new Vec3(0, 1, 9), session.level().portals().get(2).centre());
    }

    @Test
    void renamingFollowsReferencesAndNotes() {
        ScriptedSession session = ScriptedSession.empty()
                .run(
                        "add materials id=brick",
                        "brush box min=0,0,0 max=1,1,1 id=block",
                        "set material to=brick",
                        "hide",
                        "select ids=materials/brick",
                        "rename id=stone",
                        "select ids=solids/block",
                        "rename id=wall");
        assertEquals("stone", session.level().solids().get(0).material());
        assertEquals(List.of("solids/wall"), session.level().editor().hidden());
        session.run("select ids=materials/stone", "select-users");
        assertEquals(
                List.of(EntityRef.of("solids/wall")),
                session.session().document().selection().entities());
        session.run("delete");
        assertEquals(List.of(), session.level().editor().hidden());
    }

    @Test
    void whatWasSavedIsReadBackEqual(@TempDir Path folder) throws Exception {
        Path file = folder.resolve("a room.json");
        ScriptedSession session =
                ScriptedSession.empty().run("brush box min=0,0,0 max=1,1,1", "hide", "save file=\"" + file + "\"");
        assertEquals(session.level(), LevelFile.read(file));
        assertTrue(!session.session().document().isModified());
        session.run("screenshot file=\"" + folder.resolve("picture.png") + "\"");
        assertTrue(Files.size(folder.resolve("picture.png")) > 0);
    }

    @Test
    void focusKeepsTheKindsOfPanes() {
        ScriptedSession session = ScriptedSession.empty().run("brush box min=0,0,0 max=9,9,9");
        var before = session.session().panes();
        session.run("focus", "camera at=1,2,3 yaw=90");
        var after = session.session().panes();
        for (int i = 0; i < before.views().size(); i++) {
            assertEquals(before.views().get(i).kind(), after.views().get(i).kind());
        }
        assertEquals(new Vec3(1, 2, 3), after.views().get(0).perspective().eye());
        assertEquals(90, after.views().get(0).perspective().yawDegrees());
    }

    @Test
    void aMergeTellsOfGapsThatItFills() {
        ScriptedSession apart = ScriptedSession.empty()
                .run("brush min=0,0,0 max=1,1,1 id=a", "brush min=2,0,0 max=3,1,1 id=b", "select-all", "merge");
        assertEquals(1, apart.level().solids().size());
        assertTrue(apart.session().status().english().contains("fills the gaps"));
        ScriptedSession joined = ScriptedSession.empty()
                .run("brush min=0,0,0 max=1,1,1 id=a", "brush min=1,0,0 max=3,1,1 id=b", "select-all", "merge");
        assertEquals(Words.NONE, joined.session().status());
    }
}
