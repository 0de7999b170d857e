package nephele.editor.action;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.ArrayList;
import java.util.List;
import nephele.editor.brush.TextureLock;
import nephele.editor.document.Document;
import nephele.editor.text.Words;
import nephele.editor.transform.EntityTransform;
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
                "add lights.point at=1e8,0,0 | Position",
                "add solids.box at=0,-1e8,0 | Centre",
                "add player at=0,1e8,0 | Feet",
                "add cameras at=0,0,1.0000001e7 | Position",
                "add exits at=1e300,0,0 | Feet",
                "move by=1e8,0,0 | Centre",
                "paste by=1e8,0,0 | Centre",
                "duplicate by=0,0,1e8 | Centre",
                "turn axis=0,1,0 degrees=90 pivot=1e8,0,0 | Position",
                "scale by=1e9,1e9,1e9 pivot=2,2,2 | Position"
            })
    void whateverMakesAPlaceOutsideTheWorldIsRefusedInTheSameWords(String line, String field) {
        ScriptedSession session = session();
        String before = session.json();
        ActionFailure failure =
                assertThrows(ActionFailure.class, () -> session.script().run(line));
        assertEquals(field + BEYOND, failure.getMessage().trim());
        assertEquals(before, session.json());
    }

    @Test
    void aDragThatEndsOutsideTheWorldIsTakenBackAndTold() {
        Document document = session().session().document();
        Level before = document.level();
        List<Words> told = new ArrayList<>();
        document.onRefusal(told::add);
        document.drag(start -> start.with(EntityTransform.moved(
                start.level(), start.selection().entities(), new Vec3(1e8, 0, 0), TextureLock.WORLD)));
        document.commitDrag(Words.same("move"));
        assertEquals(before, document.level());
        assertEquals(1, told.size());
        assertEquals("Centre" + BEYOND, told.get(0).english().trim());
    }

    @Test
    void whatWasThereBeforeIsNotJudgedAgain() {
        Document document = session().session().document();
        document.reset((Level) document.entities()
                .changed(
                        document.level(),
                        document.selection().entities(),
                        entity -> EntityTransform.scaled(entity, new Vec3(2, 2, 2), new Vec3(1e9, 1e9, 1e9))));
        Level out = document.level();
        document.edit(Words.same("name"), level -> (Level)
                document.entities().added(level, "materials", level.materials().get(0)));
        assertEquals(out.materials().size() + 1, document.level().materials().size());
    }
}
