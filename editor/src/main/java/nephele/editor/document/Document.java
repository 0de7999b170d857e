package nephele.editor.document;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import nephele.editor.record.Entities;
import nephele.editor.record.EntityRef;
import nephele.editor.text.Limits;
import nephele.editor.text.Words;
import nephele.engine.level.Level;

/**
 * The level under edit, with its history and the drag in progress. Used by one thread, the event dispatch thread of the
 * window; others get snapshots.
 */
public final class Document {
    private final List<BiConsumer<Snapshot, Snapshot>> listeners = new ArrayList<>();
    private final List<Consumer<Words>> refusals = new ArrayList<>();
    private History history;
    /** The state that a drag shows and has not made a step yet; {@code null} without a drag. */
    private Snapshot preview;

    public Document(Level level) {
        history = new History(new Snapshot(level, Selection.NONE));
    }

    /**
     * Registers a listener until the registration is closed.
     *
     * @param listener gets the states before and after each change of level, selection or history
     */
    public Registration listen(BiConsumer<Snapshot, Snapshot> listener) {
        listeners.add(listener);
        return () -> listeners.remove(listener);
    }

    /** Registers a listener to the reasons of refused steps, until the registration is closed. */
    public Registration onRefusal(Consumer<Words> listener) {
        refusals.add(listener);
        return () -> refusals.remove(listener);
    }

    /** Returns what is shown: the state of the drag in progress, or the current snapshot. */
    public Snapshot now() {
        return preview == null ? history.current() : preview;
    }

    public Level level() {
        return now().level();
    }

    public Selection selection() {
        return now().selection();
    }

    public History history() {
        return history;
    }

    public boolean isDragging() {
        return preview != null;
    }

    /** Replaces the document by another level with an empty history; ends a drag. */
    public void reset(Level level) {
        Snapshot before = now();
        preview = null;
        history = new History(new Snapshot(level, Selection.NONE));
        tell(before);
    }

    /** Makes a step, unless the level stays as it is, or the step is refused since a file could not hold it. */
    public void edit(Words label, UnaryOperator<Level> change) {
        edit(label, null, snapshot -> snapshot.with(change.apply(snapshot.level())));
    }

    /**
     * Makes a step that may also change the selection.
     *
     * @param mergeKey as in {@link History#add}
     */
    public void edit(Words label, String mergeKey, UnaryOperator<Snapshot> change) {
        cancelDrag();
        Snapshot before = history.current();
        Snapshot after = existing(change.apply(before));
        if (isRefused(before, after)) {
            return;
        } else if (!after.level().equals(before.level())) {
            history.add(label, mergeKey, after);
        } else if (!after.selection().equals(before.selection())) {
            history.select(after.selection());
        } else {
            return;
        }
        tell(before);
    }

    /** Changes the selection; what does not exist is dropped. During a drag, the drag's state has the new selection. */
    public void select(Selection selection) {
        Snapshot before = now();
        Snapshot after = existing(before.with(selection));
        if (after.selection().equals(before.selection())) {
            return;
        }
        if (preview == null) {
            history.select(after.selection());
        } else {
            preview = after;
        }
        tell(before);
    }

    /** Shows a state that {@link #commitDrag} makes a step or {@link #cancelDrag} takes back. */
    public void drag(UnaryOperator<Snapshot> changeOfStart) {
        Snapshot before = now();
        preview = existing(changeOfStart.apply(history.current()));
        tell(before);
    }

    /** Makes the drag one step, or takes it back if a file could not hold it; does nothing without a drag. */
    public void commitDrag(Words label) {
        commitDrag(label, null);
    }

    /** Makes the drag one step, as {@link #commitDrag(Words)}, with a key as in {@link History#add}. */
    public void commitDrag(Words label, String mergeKey) {
        if (preview == null) {
            return;
        }
        Snapshot before = preview;
        preview = null;
        boolean isRefused = isRefused(history.current(), before);
        if (!isRefused && !before.level().equals(history.current().level())) {
            history.add(label, mergeKey, before);
        } else if (!isRefused) {
            history.select(before.selection());
        }
        tell(before);
    }

    /** Shows the state before the drag again; does nothing without a drag. */
    public void cancelDrag() {
        if (preview != null) {
            Snapshot before = preview;
            preview = null;
            tell(before);
        }
    }

    /** Takes back the last step; a drag in progress is cancelled first. */
    public void undo() {
        move(history::undo);
    }

    /** Makes the last step that was taken back again. */
    public void redo() {
        move(history::redo);
    }

    /** Goes to the state after a number of steps. */
    public void goTo(int steps) {
        move(() -> history.goTo(steps));
    }

    private void move(Runnable change) {
        cancelDrag();
        Snapshot before = history.current();
        change.run();
        tell(before);
    }

    /** Marks the current level as saved. */
    public void markSaved() {
        history.markSaved();
        tell(now());
    }

    /** Notes that no state of the level is on disk any more, such as after its file was deleted. */
    public void markUnsaved() {
        history.markUnsaved();
        tell(now());
    }

    public boolean isModified() {
        return history.isModified();
    }

    /** Returns true, and reports why, if a file could not hold what a step makes, such as a place outside the world. */
    private boolean isRefused(Snapshot before, Snapshot after) {
        Optional<Words> problem = Limits.change(before.level(), after.level());
        problem.ifPresent(words -> List.copyOf(refusals).forEach(listener -> listener.accept(words)));
        return problem.isPresent();
    }

    private Snapshot existing(Snapshot snapshot) {
        Selection selection = snapshot.selection();
        if (selection.isEmpty()) {
            return snapshot;
        }
        Set<EntityRef> present = new HashSet<>(Entities.LEVEL.all(snapshot.level()));
        return snapshot.with(selection.only(present::contains));
    }

    private void tell(Snapshot before) {
        Snapshot after = now();
        List.copyOf(listeners).forEach(listener -> listener.accept(before, after));
    }
}
