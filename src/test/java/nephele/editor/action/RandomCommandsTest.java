package nephele.editor.action;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import nephele.editor.document.Document;
import nephele.editor.record.EntityRef;
import nephele.editor.session.NewDocument;
import nephele.engine.level.json.LevelJson;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** Random commands, all undone and redone: the text of every state is the same both ways. */
@Execution(ExecutionMode.CONCURRENT)
class RandomCommandsTest {
    private static final int COMMANDS = 400;

    private static final List<String> LINES = List.of(
            "brush box min=%d,0,%d max=%d,3,%d",
            "brush wedge min=%d,0,%d max=%d,3,%d",
            "brush cylinder min=%d,0,%d max=%d,2,%d",
            "add lights.point at=%d,3,%d",
            "add bodies.sphere at=%d,1,%d",
            "add portals at=%d,1,%d",
            "add environment.clouds at=%d,50,%d",
            "add player at=%d,0,%d",
            "add environment.sun",
            "move by=%d,0.5,%d",
            "turn degrees=90 pivot=%d,0,%d",
            "turn degrees=37 pivot=%d,0,%d",
            "scale by=0.5,2,1 pivot=%d,0,%d",
            "duplicate by=%d,0,%d",
            "delete",
            "hide",
            "lock",
            "group",
            "ungroup",
            "show-all",
            "unlock-all",
            "hollow wall=0.25",
            "subtract",
            "merge",
            "copy",
            "paste by=%d,1,%d",
            "isolate",
            "set portalable to=true",
            "undo",
            "redo");

    @Test
    void undoingAndRedoingEverythingGivesTheSameTexts() {
        SplittableRandom random = new SplittableRandom(15);
        ScriptedSession session = ScriptedSession.empty();
        for (int i = 0; i < COMMANDS; i++) {
            chooseSelection(session, random);
            run(session, random);
        }
        Document document = session.session().document();
        while (document.history().canRedo()) {
            document.redo();
        }
        List<String> forwards = new ArrayList<>(List.of(session.json()));
        while (document.history().canUndo()) {
            document.undo();
            forwards.add(0, session.json());
        }
        assertEquals(LevelJson.write(NewDocument.opened().level()), session.json());
        for (String expected : forwards) {
            assertEquals(expected, session.json());
            document.redo();
        }
    }

    private static void chooseSelection(ScriptedSession session, SplittableRandom random) {
        Document document = session.session().document();
        List<EntityRef> all = document.entities().all(document.level());
        if (!all.isEmpty() && random.nextInt(3) > 0) {
            String ids = all.get(random.nextInt(all.size())) + "," + all.get(random.nextInt(all.size()));
            session.run("select ids=" + ids);
        }
    }

    /** A command that is not possible now, or that a brush refuses, changes nothing. */
    private static void run(ScriptedSession session, SplittableRandom random) {
        Object[] numbers = {random.nextInt(9) - 4, random.nextInt(9) - 4, random.nextInt(4) + 5, random.nextInt(4) + 5};
        String line = String.format(LINES.get(random.nextInt(LINES.size())), numbers);
        String before = session.json();
        try {
            session.script().run(line);
        } catch (ActionFailure refused) {
            assertEquals(before, session.json(), line);
        }
    }
}
