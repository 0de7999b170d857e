package nephele.editor.action;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import nephele.editor.document.Document;
import nephele.editor.document.EntityTransform;
import nephele.editor.record.Entities;
import nephele.editor.text.EditorRefusal;
import nephele.editor.text.Words;
import nephele.engine.level.Level;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A step that makes what no file can hold is refused in one place, whatever makes it, and the level stays. */
@Execution(ExecutionMode.CONCURRENT)
class OutOfRangeTest {
    private static final String BEYOND = " must be from -10000000 to 10000000 m";
    private static final String OF_ARGUMENT = " must be a number from -10000000 to 10000000, not ";

    private static ScriptedSession session() {
        return ScriptedSession.empty()
                .run(
                        "add materials id=oak",
                        "brush box min=0,0,0 max=1,1,1 id=block",
                        "add lights.point at=0,3,0 id=lamp",
                        "add kind=environment.sky.atmosphere",
                        "select ids=solids/block,lights/lamp",
                        "copy");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "add lights.point at=1e8,0,0 | at",
                "add solids.box at=0,-1e8,0 | at",
                "add player at=0,1e8,0 | at",
                "add cameras at=0,0,1.0000001e7 | at",
                "add exits at=1e300,0,0 | at",
                "move by=1e8,0,0 | by",
                "paste by=1e8,0,0 | by",
                "duplicate by=0,0,1e8 | by",
                "turn axis=0,1,0 degrees=90 pivot=1e8,0,0 | pivot",
                "scale by=1e9,1e9,1e9 pivot=2,2,2 | by"
            })
    void anArgumentOutsideTheWorldIsRefused(String line, String argument) {
        ScriptedSession session = session();
        String before = session.json();
        EditorRefusal failure =
                assertThrows(EditorRefusal.class, () -> session.script().run(line));
        assertTrue(failure.getMessage().startsWith(argument + OF_ARGUMENT), failure.getMessage());
        assertEquals(before, session.json());
    }

    /** Arguments within the world, which together lead out of it. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "add solids.box at=1e7,0,0 | move by=9e6,0,0 | Centre",
                "add lights.point at=0,1e7,0 | duplicate by=0,5,0 | Position",
                "add player at=0,0,-1e7 | move by=0,0,-1 | Feet",
                "add lights.point at=1e7,0,0 | turn axis=0,1,0 degrees=-45 pivot=0,0,1e7 | Position"
            })
    void whateverMakesAPlaceOutsideTheWorldIsRefusedInTheSameWords(String first, String line, String field) {
        ScriptedSession session = session().run(first);
        String before = session.json();
        EditorRefusal failure =
                assertThrows(EditorRefusal.class, () -> session.script().run(line));
        assertEquals(field + BEYOND, failure.getMessage().trim());
        assertEquals(before, session.json());
    }

    @Test
    void aDragThatEndsOutsideTheWorldIsTakenBackAndTold() {
        Document document = session().session().document();
        Level before = document.level();
        List<Words> told = new ArrayList<>();
        document.onRefusal(told::add);
        document.drag(start -> start.with(
                EntityTransform.moved(start.level(), start.selection().entities(), new Vec3(1e8, 0, 0), false)));
        document.commitDrag(Words.same("move"));
        assertEquals(before, document.level());
        assertEquals(1, told.size());
        assertEquals("Centre" + BEYOND, told.get(0).english().trim());
    }

    @Test
    void whatWasThereBeforeIsNotJudgedAgain() {
        Document document = session().session().document();
        document.reset(Entities.LEVEL.changed(
                document.level(),
                document.selection().entities(),
                entity -> EntityTransform.scaled(entity, new Vec3(2, 2, 2), new Vec3(1e9, 1e9, 1e9))));
        Level out = document.level();
        document.edit(
                Words.same("name"),
                level -> Entities.LEVEL.added(
                        level, "materials", level.materials().get(0)));
        assertEquals(out.materials().size() + 1, document.level().materials().size());
    }
}
