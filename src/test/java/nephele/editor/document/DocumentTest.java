package nephele.editor.document;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import nephele.editor.record.EntityRef;
import nephele.editor.text.Words;
import nephele.engine.level.Level;
import nephele.engine.level.Solid;
import nephele.engine.level.TextureMapping;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

@Execution(ExecutionMode.CONCURRENT)
class DocumentTest {
    private static final Words STEP = Words.same("step");

    private final Level start = FRESH;
    private static final Level FRESH = Level.of(
            "",
            "",
            new nephele.engine.level.Environment(
                    null,
                    null,
                    null,
                    nephele.engine.level.Exposure.NEUTRAL,
                    nephele.engine.level.ToneCurve.CLIP,
                    null,
                    List.of()),
            List.of());
    private final Document document = new Document(start);

    private static Level with(Level level, String id) {
        Solid box = new Solid.Box(id, null, false, TextureMapping.WORLD, Vec3.ZERO, new Vec3(1, 1, 1), Map.of());
        return level.with(level.materials(), List.of(box));
    }

    @Test
    void aDragIsOneStepOrNone() {
        document.drag(before -> before.with(with(before.level(), "a")));
        document.drag(before -> before.with(with(before.level(), "b")));
        assertEquals("b", document.level().solids().get(0).id());
        document.cancelDrag();
        assertSame(start, document.level());
        assertFalse(document.history().canUndo());
        document.drag(before -> before.with(with(before.level(), "c")));
        document.commitDrag(STEP);
        assertEquals(List.of(STEP), document.history().labels());
        document.undo();
        assertSame(start, document.level());
    }

    @Test
    void anEditDuringADragCancelsTheDrag() {
        document.drag(before -> before.with(with(before.level(), "a")));
        document.edit(STEP, level -> with(level, "b"));
        assertEquals("b", document.level().solids().get(0).id());
        document.undo();
        assertSame(start, document.level());
    }

    @Test
    void stepsOfOneKeyInARowBecomeOne() {
        document.edit(STEP, "k", before -> before.with(with(before.level(), "a")));
        document.edit(STEP, "k", before -> before.with(with(before.level(), "b")));
        document.edit(STEP, "other", before -> before.with(with(before.level(), "c")));
        assertEquals(2, document.history().labels().size());
        document.undo();
        document.undo();
        assertSame(start, document.level());
    }

    @Test
    void aSavedStateIsKnownAfterUndoAndRedo() {
        document.edit(STEP, level -> with(level, "a"));
        assertTrue(document.isModified());
        document.markSaved();
        assertFalse(document.isModified());
        document.undo();
        assertTrue(document.isModified());
        document.redo();
        assertFalse(document.isModified());
        document.undo();
        document.edit(STEP, level -> with(level, "b"));
        assertTrue(document.isModified());
        document.undo();
        assertTrue(document.isModified());
    }

    @Test
    void stepsAfterASaveDoNotMergeIntoTheSavedOne() {
        document.edit(STEP, "k", before -> before.with(with(before.level(), "a")));
        document.markSaved();
        document.edit(STEP, "k", before -> before.with(with(before.level(), "b")));
        document.undo();
        assertFalse(document.isModified());
    }

    @Test
    void theSelectionHasOnlyWhatExists() {
        EntityRef box = EntityRef.of("solids/a");
        document.select(Selection.of(box));
        assertTrue(document.selection().isEmpty());
        document.edit(STEP, null, before -> new Snapshot(with(before.level(), "a"), Selection.of(box)));
        assertTrue(document.selection().contains(box));
        document.undo();
        assertTrue(document.selection().isEmpty());
        document.redo();
        assertTrue(document.selection().contains(box));
    }
}
