package nephele.editor.action;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import nephele.editor.action.EditorAction.Menu;
import nephele.editor.action.EditorAction.Subject;
import nephele.editor.document.Document;
import nephele.editor.document.NoteEdits;
import nephele.editor.document.Selection;
import nephele.editor.document.Snapshot;
import nephele.editor.record.Entities;
import nephele.editor.record.EntityRef;
import nephele.editor.record.EntitySection;
import nephele.editor.record.RecordKind;
import nephele.editor.text.EditorRefusal;
import nephele.editor.text.Words;

/** Selecting by name, hiding, locking and grouping. */
final class SelectActions {
    private static final Words UNKNOWN = Words.of(
            "the level has no '%s': name entities as section/id, such as solids/wall",
            "a fase não tem '%s': nomeie entidades como seção/id, como solids/parede",
            "o nível não tem '%s': indica entidades como secção/id, como solids/parede");
    private static final Words HIDE = Words.of("Hide", "Ocultar", "Ocultar");
    private static final Words SHOW_ALL = Words.of("Show All", "Mostrar tudo", "Mostrar tudo");
    private static final Words ISOLATE = Words.of("Isolate", "Isolar", "Isolar");
    private static final Words LOCK = Words.of("Lock", "Bloquear", "Bloquear");
    private static final Words UNLOCK_ALL = Words.of("Unlock All", "Desbloquear tudo", "Desbloquear tudo");
    private static final Words GROUP = Words.of("Group", "Agrupar", "Agrupar");
    private static final Words UNGROUP = Words.of("Ungroup", "Desagrupar", "Desagrupar");

    static final List<EditorAction> ALL = List.of(
            EditorAction.of(
                            "select",
                            Words.of("Select by Name", "Selecionar pelo nome", "Selecionar pelo nome"),
                            Menu.SELECT,
                            List.of("Ctrl+F"),
                            SelectActions::select)
                    .taking("ids"),
            EditorAction.of(
                    "select-all",
                    Words.of("Select All", "Selecionar tudo", "Selecionar tudo"),
                    Menu.SELECT,
                    List.of("Ctrl+A"),
                    call -> call.session().document().select(Selection.of(selectable(call)))),
            EditorAction.of(
                    "select-none",
                    Words.of("Select Nothing", "Não selecionar nada", "Não selecionar nada"),
                    Menu.SELECT,
                    List.of("Ctrl+Shift+A"),
                    call -> call.session().document().select(Selection.NONE)),
            EditorAction.of(
                    "select-invert",
                    Words.of("Invert Selection", "Inverter seleção", "Inverter seleção"),
                    Menu.SELECT,
                    List.of("Ctrl+I"),
                    SelectActions::invert),
            EditorAction.of(
                            "select-users",
                            Words.of("Select What Uses This", "Selecionar o que usa isto", "Selecionar o que usa isto"),
                            Menu.SELECT,
                            List.of("Ctrl+U"),
                            SelectActions::users)
                    .when(EditActions::hasSelection),
            EditorAction.of("hide", HIDE, Menu.SELECT, List.of("H"), SelectActions::hide)
                    .changing(Subject.LEVEL)
                    .when(EditActions::hasSelection),
            EditorAction.of("isolate", ISOLATE, Menu.SELECT, List.of("Shift+H"), SelectActions::isolate)
                    .changing(Subject.LEVEL)
                    .when(EditActions::hasSelection),
            EditorAction.of("show-all", SHOW_ALL, Menu.SELECT, List.of("Alt+H"), call -> call.session()
                            .document()
                            .edit(SHOW_ALL, NoteEdits::allVisible))
                    .changing(Subject.LEVEL),
            EditorAction.of("lock", LOCK, Menu.SELECT, List.of("Ctrl+L"), SelectActions::lock)
                    .changing(Subject.LEVEL)
                    .when(EditActions::hasSelection),
            EditorAction.of("unlock-all", UNLOCK_ALL, Menu.SELECT, List.of("Ctrl+Shift+L"), call -> call.session()
                            .document()
                            .edit(UNLOCK_ALL, NoteEdits::allUnlocked))
                    .changing(Subject.LEVEL),
            EditorAction.of("group", GROUP, Menu.SELECT, List.of("Ctrl+G"), SelectActions::group)
                    .changing(Subject.LEVEL)
                    .when(session -> session.document().selection().entities().size() > 1),
            EditorAction.of("ungroup", UNGROUP, Menu.SELECT, List.of("Ctrl+Shift+G"), call -> call.session()
                            .document()
                            .edit(
                                    UNGROUP,
                                    level -> NoteEdits.ungrouped(
                                            level,
                                            call.session()
                                                    .document()
                                                    .selection()
                                                    .entities())))
                    .changing(Subject.LEVEL)
                    .when(EditActions::hasSelection));

    private SelectActions() {}

    private static void select(ActionCall call) throws EditorRefusal {
        if (!call.isGiven("ids", "search")) {
            return;
        }
        Document document = call.session().document();
        List<EntityRef> refs = new ArrayList<>();
        for (String id : call.words("ids")) {
            EntityRef ref = EntityRef.of(id);
            if (Entities.LEVEL.find(document.level(), ref).isEmpty()) {
                throw new EditorRefusal(UNKNOWN.with(id));
            }
            refs.add(ref);
        }
        document.select(Selection.of(refs));
    }

    /** Returns the entities of lists with a place, without materials. */
    private static List<EntityRef> selectable(ActionCall call) {
        Document document = call.session().document();
        List<EntityRef> all = new ArrayList<>();
        for (EntitySection section : Entities.LEVEL.lists()) {
            if (!section.path().equals("materials")) {
                for (Record entity : section.entities(document.level())) {
                    all.add(new EntityRef(section.path(), RecordKind.id(entity)));
                }
            }
        }
        Set<String> away = new LinkedHashSet<>(document.level().editor().hidden());
        away.addAll(document.level().editor().locked());
        all.removeIf(ref -> away.contains(ref.text()));
        return all;
    }

    private static void invert(ActionCall call) {
        List<EntityRef> others = selectable(call);
        others.removeAll(call.session().document().selection().entities());
        call.session().document().select(Selection.of(others));
    }

    private static void users(ActionCall call) {
        Document document = call.session().document();
        Set<EntityRef> users = new LinkedHashSet<>();
        document.selection().entities().forEach(ref -> users.addAll(Entities.LEVEL.usages(document.level(), ref)));
        document.select(Selection.of(users));
    }

    private static void hide(ActionCall call) {
        List<EntityRef> selected = call.session().document().selection().entities();
        call.session()
                .document()
                .edit(HIDE, null, before -> new Snapshot(NoteEdits.hidden(before.level(), selected), Selection.NONE));
    }

    private static void isolate(ActionCall call) {
        List<EntityRef> others = selectable(call);
        others.removeAll(call.session().document().selection().entities());
        call.session().document().edit(ISOLATE, level -> NoteEdits.hidden(level, others));
    }

    private static void lock(ActionCall call) {
        List<EntityRef> selected = call.session().document().selection().entities();
        call.session()
                .document()
                .edit(LOCK, null, before -> new Snapshot(NoteEdits.locked(before.level(), selected), Selection.NONE));
    }

    private static void group(ActionCall call) {
        List<EntityRef> selected = call.session().document().selection().entities();
        call.session().document().edit(GROUP, level -> NoteEdits.grouped(level, NoteEdits.freshGroup(level), selected));
    }
}
