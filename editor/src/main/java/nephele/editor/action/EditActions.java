package nephele.editor.action;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import nephele.editor.action.EditorAction.Menu;
import nephele.editor.action.EditorAction.Subject;
import nephele.editor.document.Clip;
import nephele.editor.document.Deletion;
import nephele.editor.document.Document;
import nephele.editor.document.NoteEdits;
import nephele.editor.document.Snapshot;
import nephele.editor.record.Entities;
import nephele.editor.record.EntityRef;
import nephele.editor.session.EditorSession;
import nephele.editor.text.EditorRefusal;
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
    private static final Words ONLY_ONE = Words.of(
            "a level has only one %s, which can't be copied: take it out of the selection",
            "uma fase só tem um %s, que não pode ser copiado: tire-o da seleção",
            "um nível só tem um %s, que não pode ser copiado: tira-o da seleção");
    private static final Words ONE = Words.of(
            "select one entity that has an id first",
            "selecione antes uma entidade que tenha id",
            "seleciona primeiro uma entidade que tenha id");

    private static final Words USED = Words.of(
            "used by %s: write replace=ID for what these use instead, or replace=none for the default",
            "usado por %s: escreva replace=ID com o que estes usam em vez disso, ou replace=none para o padrão",
            "usado por %s: escreve replace=ID com o que estes usam em vez disso, ou replace=none para o predefinido");
    private static final Words DELETE_USED = Words.of(
            "Used by %s. Delete it all the same? These then use the default or, where they need one, the first that is"
                    + " left.",
            "Usado por %s. Excluir mesmo assim? Estes passam a usar o padrão ou, se precisam de um, o primeiro que"
                    + " resta.",
            "Usado por %s. Eliminar mesmo assim? Estes passam a usar o predefinido ou, se precisam de um, o primeiro"
                    + " que resta.");
    private static final Words NO_SUBSTITUTE = Words.of(
            "there is no '%s' that could stand for what is deleted",
            "não há um '%s' que possa ficar no lugar do excluído",
            "não há um '%s' que possa ficar no lugar do eliminado");
    private static final String REPLACE = "replace";
    private static final String NONE = "none";
    private static final int MOST_NAMED = 3;

    static final List<EditorAction> ALL = List.of(
            EditorAction.of("undo", UNDO, Menu.EDIT, List.of("Ctrl+Z"), call -> undo(call.session()))
                    .changing(Subject.LEVEL)
                    .when(session -> session.drag().isShowing()
                            || session.document().history().canUndo()),
            EditorAction.of("redo", REDO, Menu.EDIT, List.of("Ctrl+Shift+Z", "Ctrl+Y"), call -> call.session()
                            .document()
                            .redo())
                    .changing(Subject.LEVEL)
                    .when(session -> session.document().history().canRedo()),
            EditorAction.of("cut", CUT, Menu.EDIT, List.of("Ctrl+X"), EditActions::cut)
                    .taking(REPLACE)
                    .changing(Subject.LEVEL)
                    .when(EditActions::hasSelection),
            EditorAction.of("copy", COPY, Menu.EDIT, List.of("Ctrl+C"), EditActions::copy)
                    .when(EditActions::hasSelection),
            EditorAction.of("paste", PASTE, Menu.EDIT, List.of("Ctrl+V"), EditActions::paste)
                    .changing(Subject.LEVEL)
                    .taking("by"),
            EditorAction.of("duplicate", DUPLICATE, Menu.EDIT, List.of("Ctrl+D"), EditActions::duplicate)
                    .changing(Subject.LEVEL)
                    .taking("by")
                    .when(EditActions::hasSelection),
            EditorAction.of("delete", DELETE, Menu.EDIT, List.of("Delete"), EditActions::delete)
                    .taking(REPLACE)
                    .changing(Subject.LEVEL)
                    .when(EditActions::hasSelection),
            EditorAction.of("rename", RENAME, Menu.EDIT, List.of("F2"), EditActions::rename)
                    .changing(Subject.LEVEL)
                    .taking("id")
                    .when(EditActions::hasSelection));

    private EditActions() {}

    /** Takes back the drag in progress, or without one the last step. */
    private static void undo(EditorSession session) {
        if (!session.drag().cancel()) {
            session.document().undo();
        }
    }

    /**
     * Returns what is selected and not locked.
     *
     * @throws EditorRefusal if everything selected is locked
     */
    static List<EntityRef> unlocked(ActionCall call) throws EditorRefusal {
        Document document = call.session().document();
        List<EntityRef> selected = document.selection().entities();
        List<EntityRef> unlocked = NoteEdits.unlocked(document.level(), selected);
        if (unlocked.isEmpty() && !selected.isEmpty()) {
            throw new EditorRefusal(NoteEdits.LOCKED.with(selected.get(0).text()));
        }
        return unlocked;
    }

    static boolean hasSelection(EditorSession session) {
        return !session.document().selection().entities().isEmpty();
    }

    private static void copy(ActionCall call) throws EditorRefusal {
        String text = copied(call);
        call.session().clipboard(text);
        call.ui().copy(text);
    }

    private static String copied(ActionCall call) throws EditorRefusal {
        Document document = call.session().document();
        for (EntityRef ref : document.selection().entities()) {
            if (ref.id().isEmpty()) {
                throw new EditorRefusal(ONLY_ONE.with(ref.shortName()));
            }
        }
        return Clip.text(document.level(), document.selection().entities());
    }

    private static void cut(ActionCall call) throws EditorRefusal {
        unlocked(call);
        copy(call);
        delete(call, CUT);
    }

    private static void paste(ActionCall call) throws EditorRefusal {
        String text = call.ui().pasted().isBlank()
                ? call.session().clipboard()
                : call.ui().pasted();
        paste(call, text, PASTE, call.vector("by", Vec3.ZERO));
    }

    private static void paste(ActionCall call, String text, Words label, Vec3 by) throws EditorRefusal {
        if (text.isBlank()) {
            throw new EditorRefusal(NOTHING_TO_PASTE);
        }
        Document document = call.session().document();
        Snapshot after;
        try {
            after = Clip.pasted(document.now(), text, by);
        } catch (LevelFormatException noLevel) {
            throw new EditorRefusal(NOTHING_TO_PASTE);
        }
        document.edit(label, null, before -> after);
    }

    private static void duplicate(ActionCall call) throws EditorRefusal {
        double step = call.session().grid().stepMetres();
        String text = copied(call);
        paste(call, text, DUPLICATE, call.vector("by", new Vec3(step, 0, step)));
    }

    private static void delete(ActionCall call) throws EditorRefusal {
        delete(call, DELETE);
    }

    private static void delete(ActionCall call, Words label) throws EditorRefusal {
        Document document = call.session().document();
        Deletion deletion = new Deletion(document.now(), unlocked(call));
        List<EntityRef> users = deletion.users();
        Optional<String> substitute = call.text(REPLACE).filter(id -> !id.equals(NONE));
        if (substitute.isPresent() && !deletion.substitutes().contains(substitute.get())) {
            throw new EditorRefusal(NO_SUBSTITUTE.with(substitute.get()));
        }
        if (!users.isEmpty() && call.text(REPLACE).isEmpty()) {
            if (!call.ui().hasUser()) {
                throw new EditorRefusal(USED.with(named(users)));
            }
            if (!call.ui().isAgreed(DELETE_USED.with(named(users)))) {
                return;
            }
        }
        Snapshot after = deletion.after(substitute);
        document.edit(label, null, before -> after);
    }

    /** Returns the first few names, and how many there are more. */
    private static String named(List<EntityRef> refs) {
        String first = refs.stream().limit(MOST_NAMED).map(EntityRef::text).collect(Collectors.joining(", "));
        return refs.size() > MOST_NAMED ? first + " … (" + refs.size() + ")" : first;
    }

    private static void rename(ActionCall call) throws EditorRefusal {
        if (!call.isGiven("id", "rename")) {
            return;
        }
        Document document = call.session().document();
        List<EntityRef> selected = document.selection().entities();
        if (selected.size() != 1 || selected.get(0).id().isEmpty()) {
            throw new EditorRefusal(ONE);
        }
        EntityRef before = selected.get(0);
        EntityRef after = new EntityRef(before.section(), call.needed("id"));
        if (after.equals(before)) {
            return;
        }
        if (Entities.LEVEL.find(document.level(), after).isPresent()) {
            throw new EditorRefusal(TAKEN.with(after.id()));
        }
        document.edit(RENAME, null, snapshot -> snapshot.renamed(before, after.id()));
    }
}
