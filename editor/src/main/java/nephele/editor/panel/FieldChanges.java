package nephele.editor.panel;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import nephele.editor.document.NoteEdits;
import nephele.editor.panel.model.FieldType;
import nephele.editor.panel.model.InspectorField;
import nephele.editor.panel.model.InspectorModel;
import nephele.editor.panel.model.RecordPath;
import nephele.editor.record.Entities;
import nephele.editor.record.EntityRef;
import nephele.editor.record.ListEdit;
import nephele.editor.record.RecordKind;
import nephele.editor.session.EditorSession;
import nephele.editor.terrain.LayerOrder;
import nephele.editor.text.EditorRefusal;
import nephele.editor.text.Limits;
import nephele.editor.text.Words;
import nephele.engine.level.Language;
import nephele.engine.level.Level;

/** Makes the inspector's changes steps of the document, and reports what a field does not take. */
final class FieldChanges {
    /** The layers of a terrain. */
    private static final RecordPath LAYERS = RecordPath.SELF.component("layers");

    private final EditorSession session;
    private final InspectorModel model = new InspectorModel(Entities.LEVEL);
    private final Consumer<Words> report;

    /** @param report receives what is wrong with a value, or {@link Words#NONE} */
    FieldChanges(EditorSession session, Consumer<Words> report) {
        this.session = session;
        this.report = report;
    }

    /** Returns the inspected entities: those selected, or the level itself. */
    List<EntityRef> refs() {
        List<EntityRef> selected = session.document().selection().entities();
        return selected.isEmpty() ? InspectorModel.ROOT : selected;
    }

    List<InspectorField> fields() {
        return model.fields(session.document().level(), refs());
    }

    List<String> ids(String section) {
        return model.ids(session.document().level(), section);
    }

    Language language() {
        return session.language();
    }

    void report(Words words) {
        report.accept(words);
    }

    /** Sets a value; returns false if the field does not take it. */
    boolean set(InspectorField field, Object value) {
        return change(field, null, old -> value);
    }

    /**
     * Changes each record's own value in one step.
     *
     * @param mergeKey as in {@code History.add}
     */
    boolean change(InspectorField field, String mergeKey, UnaryOperator<Object> change) {
        if (isRefused(field, change)) {
            return false;
        }
        if (field.isId()) {
            rename(field, change.apply(field.value()));
        } else {
            edit(field, mergeKey, level -> model.changed(level, refs(), field, change));
        }
        return true;
    }

    /** Returns true, and tells it, if something inspected is locked. */
    private boolean isLocked() {
        List<EntityRef> refs = refs();
        List<EntityRef> unlocked = NoteEdits.unlocked(session.document().level(), refs);
        Optional<EntityRef> locked =
                refs.stream().filter(ref -> !unlocked.contains(ref)).findFirst();
        locked.ifPresent(ref -> report.accept(NoteEdits.LOCKED.with(ref.shortName())));
        return locked.isPresent();
    }

    private boolean isRefused(InspectorField field, UnaryOperator<Object> change) {
        if (isLocked()) {
            return true;
        }
        Level level = session.document().level();
        Optional<Words> problem = field.values().stream()
                .flatMap(value -> model.problem(level, refs(), field, change.apply(value)).stream())
                .findFirst();
        report.accept(problem.orElse(Words.NONE));
        return problem.isPresent();
    }

    private void rename(InspectorField field, Object id) {
        EntityRef before = refs().get(0);
        session.document().edit(label(field), null, now -> now.renamed(before, (String) id));
    }

    /** Shows a change until {@link #endDrag}. */
    void drag(InspectorField field, UnaryOperator<Object> change) {
        List<EntityRef> refs = refs();
        if (!isRefused(field, change)) {
            session.document().drag(start -> start.with((Level) model.changed(start.level(), refs, field, change)));
        }
    }

    void endDrag(InspectorField field) {
        session.document().commitDrag(label(field));
    }

    void cancelDrag() {
        session.document().cancelDrag();
    }

    void reset(InspectorField field) {
        edit(field, null, level -> model.reset(level, refs(), field));
    }

    void unset(InspectorField field) {
        edit(field, null, level -> model.set(level, refs(), field, null));
    }

    void withKind(InspectorField field, RecordKind kind) {
        edit(field, null, level -> model.withKind(level, refs(), field, kind));
    }

    /** Sets a value where there is none. */
    void setFresh(InspectorField field) {
        Level after = (Level) model.fresh(session.document().level(), refs(), field);
        if (!isRefused(field.path(), field, after)) {
            edit(field, null, level -> after);
        }
    }

    /** Returns the keys that a table does not have yet, as far as they are known. */
    List<Object> missingKeys(InspectorField table) {
        return model.missingKeys(session.document().level(), refs(), table);
    }

    /** Adds an entry unless the list or table is full. */
    void add(InspectorField field, Object key) {
        Level after = (Level) model.added(session.document().level(), refs(), field, key);
        if (after.equals(session.document().level())) {
            report.accept(Limits.tooMany(field.type().field(), listLength(field)));
        } else if (!isRefused(field.path(), field, after)) {
            edit(field, null, level -> after);
        }
    }

    private static int listLength(InspectorField list) {
        return list.value() instanceof List<?> entries ? entries.size() : 0;
    }

    /** Returns true, and tells why, if the value at a path of a level would be wrong. */
    private boolean isRefused(RecordPath path, InspectorField field, Level after) {
        FieldType type = FieldType.of(field.type().field());
        Optional<Words> problem = model.fields(after, refs()).stream()
                .filter(changed -> changed.path().equals(path))
                .flatMap(changed -> changed.values().stream())
                .flatMap(value -> type.problem(value).stream())
                .findFirst();
        report.accept(problem.orElse(Words.NONE));
        return problem.isPresent();
    }

    void remove(InspectorField entry) {
        if (entry.path().last().entry() instanceof Integer index) {
            edit(entry, ListEdit.removed(index));
        } else {
            edit(entry, null, level -> model.removed(level, refs(), entry));
        }
    }

    /** Returns how many entries the list of an entry has. */
    int length(InspectorField entry) {
        return model.length(session.document().level(), refs(), entry);
    }

    /** Makes an edit of the list that has an entry one step; the paint of terrains follows their layers. */
    void edit(InspectorField entry, ListEdit edit) {
        Level before = session.document().level();
        Level after = (Level) model.listEdited(before, refs(), entry, edit);
        RecordPath list = entry.path().owner();
        if (isRefused(list, entry, after)) {
            return;
        }
        try {
            Level followed = list.equals(LAYERS) && after.terrains() != before.terrains()
                    ? session.background()
                            .get(() -> LayerOrder.followed(before, after, edit, session.assets(), session.maps()))
                    : after;
            edit(entry, null, level -> followed);
        } catch (EditorRefusal refusal) {
            report.accept(refusal.words());
        }
    }

    private void edit(InspectorField field, String mergeKey, UnaryOperator<Record> change) {
        if (isLocked()) {
            return;
        }
        session.document().edit(label(field), mergeKey, now -> now.with((Level) change.apply(now.level())));
    }

    private static Words label(InspectorField field) {
        return field.words();
    }
}
