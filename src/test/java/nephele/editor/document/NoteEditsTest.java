package nephele.editor.document;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.charset.StandardCharsets;
import java.util.List;
import nephele.editor.record.EntityRef;
import nephele.engine.level.EditorNotes;
import nephele.engine.level.Level;
import nephele.engine.level.json.LevelJson;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** Hiding and locking, and what is left of an entity that is gone or has another name. */
@Execution(ExecutionMode.CONCURRENT)
class NoteEditsTest {
    private static final EntityRef A = EntityRef.of("exits/a");
    private static final EntityRef B = EntityRef.of("exits/b");

    private static Level level() {
        String json =
                "{\"format\": \"nephele-level\", \"version\": 1, \"exits\": [{\"id\": \"a\", \"feet\": [0, 0, 0]},"
                        + " {\"id\": \"b\", \"feet\": [3, 0, 0]}]}";
        return LevelJson.read("notes", json.getBytes(StandardCharsets.UTF_8));
    }

    @Test
    void hidingTogglesOnlyWhenAllAreHidden() {
        Level one = NoteEdits.hiddenToggled(level(), List.of(A));
        Level both = NoteEdits.hiddenToggled(one, List.of(A, B));
        assertEquals(List.of(A.text(), B.text()), both.editor().hidden());
        assertEquals(
                List.of(B.text()),
                NoteEdits.hiddenToggled(both, List.of(A)).editor().hidden());
        assertEquals(
                List.of(), NoteEdits.hiddenToggled(both, List.of(A, B)).editor().hidden());
    }

    @Test
    void lockingTogglesOnlyWhenAllAreLocked() {
        Level one = NoteEdits.lockedToggled(level(), List.of(B));
        Level both = NoteEdits.lockedToggled(one, List.of(A, B));
        assertEquals(List.of(B.text(), A.text()), both.editor().locked());
        assertEquals(
                List.of(), NoteEdits.lockedToggled(both, List.of(A, B)).editor().locked());
    }

    @Test
    void aRemovedOrRenamedEntityIsSoInLevelNotesAndSelection() {
        Level noted = NoteEdits.grouped(
                NoteEdits.locked(NoteEdits.hidden(level(), List.of(A)), List.of(A, B)), "g", List.of(A, B));
        var all = new Snapshot(noted, Selection.of(List.of(A, B)));
        Snapshot without = all.without(List.of(A));
        assertEquals(1, without.level().exits().size());
        assertEquals(
                new EditorNotes(List.of(), List.of(), List.of(B.text()), List.of()),
                without.level().editor());
        assertEquals(Selection.of(B), without.selection());
        Snapshot renamed = all.renamed(A, "c");
        assertEquals("c", renamed.level().exits().get(0).id());
        assertEquals(List.of("exits/c"), renamed.level().editor().hidden());
        assertEquals("exits/c", renamed.selection().entities().get(0).text());
    }
}
