package nephele.editor.action;

import java.util.ArrayList;
import java.util.List;
import nephele.editor.action.EditorAction.Menu;
import nephele.editor.document.Clip;
import nephele.editor.document.Document;
import nephele.editor.document.Snapshot;
import nephele.editor.record.EntityRef;
import nephele.editor.session.EditorSession;
import nephele.editor.text.Words;
import nephele.engine.level.json.LevelFormatException;
import nephele.engine.math.Vec3;

/** Undo, the clipboard, and what happens to selected entities of any kind. */
final class EditActions {
    private static final Words UNDO = Words.of("Undo", "Desfazer", "Anular");
    private static final Words REDO = Words.of("Redo", "Refazer", "Refazer");
    private static final Words CUT = Words.of("Cut", "Recortar", "Cortar");
    private static final Words COPY = Words.of("Copy", "Copiar", "Copiar");
    private static final Words PASTE = Words.of("Paste", "Colar", "Colar");
    private static final Words DUPLICATE = Words.of("Duplicate", "Duplicar", "Duplicar");
    private static final Words DELETE = Words.of("Delete", "Excluir", "Eliminar");
    private static final Words RENAME = Words.of("Rename", "Renomear", "Mudar o nome");
    private static final Words NOTHING_TO_PASTE = Words.of(
            "the clipboard has no entities: copy some first",
            "a área de transferência não tem entidades: copie algumas antes",
            "a área de transferência não tem entidades: copia algumas primeiro");
    private static final Words TAKEN = Words.of(
            "'%s' is the id of another entity: choose another",
            "'%s' é o id de outra entidade: escolha outro", "'%s' é o id de outra entidade: escolhe outro");
    private static final Words ONE = Words.of(
            "select one entity that has an id first",
            "selecione antes uma entidade que tenha id",
            "seleciona primeiro uma entidade que tenha id");

    static final List<EditorAction> ALL = List.of(
            EditorAction.of("undo", UNDO, Menu.EDIT, List.of("Ctrl+Z"), call -> undo(call.session()))
                    .when(session -> session.drag().isShowing()
                            || session.document().history().canUndo()),
            EditorAction.of("redo", REDO, Menu.EDIT, List.of("Ctrl+Shift+Z", "Ctrl+Y"), call -> call.session()
                            .document()
                            .redo())
                    .when(session -> session.document().history().canRedo()),
            EditorAction.of("cut", CUT, Menu.EDIT, List.of("Ctrl+X"), EditActions::cut)
                    .when(EditActions::hasSelection),
            EditorAction.of("copy", COPY, Menu.EDIT, List.of("Ctrl+C"), EditActions::copy)
                    .when(EditActions::hasSelection),
            EditorAction.of("paste", PASTE, Menu.EDIT, List.of("Ctrl+V"), EditActions::paste)
                    .taking("by"),
            EditorAction.of("duplicate", DUPLICATE, Menu.EDIT, List.of("Ctrl+D"), EditActions::duplicate)
                    .taking("by")
                    .when(EditActions::hasSelection),
            EditorAction.of("delete", DELETE, Menu.EDIT, List.of("Delete"), EditActions::delete)
                    .when(EditActions::hasSelection),
            EditorAction.of("rename", RENAME, Menu.EDIT, List.of("F2"), EditActions::rename)
                    .taking("id")
                    .when(EditActions::hasSelection));

    private EditActions() {}

    /** Takes back the drag in progress, or without one the last step. */
    private static void undo(EditorSession session) {
        if (!session.drag().cancel()) {
            session.document().undo();
        }
    }

    static boolean hasSelection(EditorSession session) {
        return !session.document().selection().entities().isEmpty();
    }

    private static void copy(ActionCall call) {
        Document document = call.session().document();
        String text = Clip.text(document.level(), document.selection().entities(), document.entities());
        call.session().clipboard(text);
        call.desk().copy(text);
    }

    private static void cut(ActionCall call) {
        copy(call);
        delete(call, CUT);
    }

    private static void paste(ActionCall call) throws ActionFailure {
        String text = call.desk().pasted().isBlank()
                ? call.session().clipboard()
                : call.desk().pasted();
        paste(call, text, PASTE, call.vector("by", Vec3.ZERO));
    }

    private static void paste(ActionCall call, String text, Words label, Vec3 by) throws ActionFailure {
        if (text.isBlank()) {
            throw new ActionFailure(NOTHING_TO_PASTE);
        }
        Document document = call.session().document();
        Snapshot after;
        try {
            after = Clip.pasted(document.now(), text, by, document.entities());
        } catch (LevelFormatException noLevel) {
            throw new ActionFailure(NOTHING_TO_PASTE);
        }
        document.edit(label, null, before -> after);
    }

    private static void duplicate(ActionCall call) throws ActionFailure {
        Document document = call.session().document();
        double step = call.session().grid().stepMetres();
        String text = Clip.text(document.level(), document.selection().entities(), document.entities());
        paste(call, text, DUPLICATE, call.vector("by", new Vec3(step, 0, step)));
    }

    private static void delete(ActionCall call) {
        delete(call, DELETE);
    }

    private static void delete(ActionCall call, Words label) {
        Document document = call.session().document();
        List<EntityRef> refs = new ArrayList<>(document.selection().entities());
        document.edit(label, null, before -> before.without(refs));
    }

    private static void rename(ActionCall call) throws ActionFailure {
        if (call.text("id").isEmpty()) {
            call.desk().show("rename");
            return;
        }
        Document document = call.session().document();
        List<EntityRef> selected = document.selection().entities();
        if (selected.size() != 1 || selected.get(0).id().isEmpty()) {
            throw new ActionFailure(ONE);
        }
        EntityRef before = selected.get(0);
        EntityRef after = new EntityRef(before.section(), call.needed("id"));
        if (after.equals(before)) {
            return;
        }
        if (document.entities().find(document.level(), after).isPresent()) {
            throw new ActionFailure(TAKEN.with(after.id()));
        }
        document.edit(RENAME, null, snapshot -> snapshot.renamed(before, after.id()));
    }
}
