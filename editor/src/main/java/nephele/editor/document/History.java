package nephele.editor.document;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import nephele.editor.text.Words;

/** All snapshots of a document, each with the label of the step that made it; the position in them moves by undo and redo. */
public final class History {
    /** A snapshot with the step that led to it. */
    private record Step(Words label, String mergeKey, Snapshot snapshot) {}

    private final List<Step> steps = new ArrayList<>();
    private int current;
    private int saved;

    public History(Snapshot start) {
        steps.add(new Step(Words.NONE, null, start));
    }

    public Snapshot current() {
        return steps.get(current).snapshot;
    }

    /**
     * Adds a step; steps that were undone are dropped.
     *
     * @param mergeKey steps in a row with the same key become one, such as repeated presses of an arrow key; {@code
     *     null} for none
     */
    public void add(Words label, String mergeKey, Snapshot snapshot) {
        boolean merges = mergeKey != null
                && current > 0
                && current == steps.size() - 1
                && current != saved
                && mergeKey.equals(steps.get(current).mergeKey);
        steps.subList(current + 1, steps.size()).clear();
        if (saved > current) {
            saved = -1;
        }
        if (merges) {
            steps.set(current, new Step(label, mergeKey, snapshot));
        } else {
            steps.add(new Step(label, mergeKey, snapshot));
            current++;
        }
    }

    /** Replaces the selection of the current snapshot; selecting alone is no step of its own. */
    public void select(Selection selection) {
        Step now = steps.get(current);
        steps.set(current, new Step(now.label, now.mergeKey, now.snapshot.with(selection)));
    }

    public boolean canUndo() {
        return current > 0;
    }

    public boolean canRedo() {
        return current < steps.size() - 1;
    }

    /** Goes one step back; does nothing at the start. */
    public void undo() {
        current = Math.max(0, current - 1);
    }

    /** Goes one step forward; does nothing at the end. */
    public void redo() {
        current = Math.min(steps.size() - 1, current + 1);
    }

    /** Goes to the snapshot after a number of steps from the start. */
    public void goTo(int steps) {
        current = Math.max(0, Math.min(this.steps.size() - 1, steps));
    }

    /** Returns the number of steps from the start to the current snapshot. */
    public int position() {
        return current;
    }

    /** Returns the labels of all steps, those undone included. */
    public List<Words> labels() {
        return steps.subList(1, steps.size()).stream().map(Step::label).toList();
    }

    /** Returns the label of the step that undo takes back. */
    public Optional<Words> undoLabel() {
        return canUndo() ? Optional.of(steps.get(current).label) : Optional.empty();
    }

    /** Marks the current snapshot as the saved one. */
    public void markSaved() {
        saved = current;
    }

    /** Notes that no snapshot is on disk any more. */
    void markUnsaved() {
        saved = -1;
    }

    /** Returns true if the current level is not the saved one. */
    public boolean isModified() {
        return saved < 0 || steps.get(saved).snapshot.level() != current().level();
    }
}
