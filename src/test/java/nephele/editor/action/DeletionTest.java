package nephele.editor.action;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import nephele.editor.text.EditorRefusal;
import nephele.editor.text.Words;
import nephele.engine.level.Level;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What others refer to is deleted only when that is said, and they are given something else then. */
@Execution(ExecutionMode.CONCURRENT)
class DeletionTest {
    private static ScriptedSession level() {
        return ScriptedSession.empty()
                .run(
                        "add materials id=red",
                        "add materials id=blue",
                        "brush box min=0,0,0 max=1,1,1 id=block material=red",
                        "add terrains id=hills",
                        "add cameras id=main",
                        "add player",
                        "add observer",
                        "set camera to=main",
                        "add portals id=a at=0,1,0",
                        "add portals id=b at=5,1,0",
                        "set linkedTo to=a",
                        "add models id=trunk",
                        "add models id=leaf",
                        "set parent to=trunk");
    }

    @ParameterizedTest
    @CsvSource({
        "materials/red, solids/block",
        "cameras/main, observer",
        "portals/a, portals/b",
        "models/trunk, models/leaf"
    })
    void whatIsUsedStaysAndItsUsersAreNamed(String used, String user) {
        for (String action : List.of("delete", "cut")) {
            ScriptedSession session = level().run("select " + used);
            String before = session.json();
            String said = assertThrows(
                            EditorRefusal.class, () -> session.script().run(action))
                    .getMessage();
            assertTrue(said.contains(user) && said.contains("replace="), said);
            assertEquals(before, session.json());
        }
    }

    @Test
    void usersAreGivenTheDefaultOrAnotherOne() {
        Level defaults = level().run(
                        "select materials/red", "delete replace=none", "select cameras/main", "delete none")
                .level();
        assertNull(defaults.solids().get(0).material());
        assertNull(defaults.observer().camera());
        Level other = level().run("select materials/red", "delete replace=blue").level();
        assertEquals("blue", other.solids().get(0).material());
        Level lonely = level().run("select portals/a", "delete replace=none").level();
        assertEquals("b", lonely.portals().get(0).linkedTo());
        ScriptedSession wrong = level().run("select materials/red");
        assertThrows(EditorRefusal.class, () -> wrong.script().run("delete replace=red"));
        assertThrows(EditorRefusal.class, () -> wrong.script().run("delete replace=green"));
    }

    @Test
    void whatIsDeletedTogetherIsNotInItsOwnWay() {
        Level level = level().run("select portals/a,portals/b,materials/red,solids/block", "delete")
                .level();
        assertEquals(List.of(), level.portals());
        assertEquals(List.of(), level.solids());
    }

    /** A user who answers one question. */
    private record Asked(boolean isYes, List<String> questions) implements UserInterface {
        @Override
        public java.util.Optional<java.nio.file.Path> fileToOpen() {
            return java.util.Optional.empty();
        }

        @Override
        public java.util.Optional<java.nio.file.Path> fileToSave() {
            return java.util.Optional.empty();
        }

        @Override
        public boolean isAgreed(Words question) {
            questions.add(question.english());
            return isYes;
        }

        @Override
        public BufferedImage picture() {
            return null;
        }

        @Override
        public void copy(String text) {}

        @Override
        public String pasted() {
            return "";
        }

        @Override
        public void show(String part) {}

        @Override
        public void quit() {}
    }

    @Test
    void aUserIsAsked() throws EditorRefusal {
        for (boolean isYes : List.of(false, true)) {
            ScriptedSession session = level().run("select materials/red");
            List<String> questions = new ArrayList<>();
            Actions.named("delete")
                    .orElseThrow()
                    .run(new ActionCall(session.session(), new Asked(isYes, questions), Map.of()));
            assertEquals(1, questions.size());
            assertTrue(questions.get(0).contains("solids/block"), questions.get(0));
            assertEquals(isYes ? 1 : 2, session.level().materials().size());
        }
    }
}
