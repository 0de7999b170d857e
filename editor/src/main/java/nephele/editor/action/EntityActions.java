package nephele.editor.action;

import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.UnaryOperator;
import nephele.editor.action.EditorAction.Menu;
import nephele.editor.document.Document;
import nephele.editor.document.Selection;
import nephele.editor.document.Snapshot;
import nephele.editor.panel.model.FieldType;
import nephele.editor.pick.EntityBounds;
import nephele.editor.record.Entities;
import nephele.editor.record.EntityRef;
import nephele.editor.record.EntitySection;
import nephele.editor.record.FieldKind;
import nephele.editor.record.LevelStructure;
import nephele.editor.record.Prototypes;
import nephele.editor.record.RecordField;
import nephele.editor.record.RecordKind;
import nephele.editor.record.SingleSection;
import nephele.editor.text.Words;
import nephele.editor.transform.EntityTransform;
import nephele.engine.level.Level;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/** Adding entities of any kind, moving, turning and scaling them, and setting their components. */
final class EntityActions {
    /** Ten turns. */
    private static final double MOST_DEGREES = 3600;

    private static final Words ADD = Words.of("Add", "Adicionar", "Adicionar");
    private static final Words MOVE = Words.of("Move", "Mover", "Mover");
    private static final Words TURN = Words.of("Turn", "Girar", "Rodar");
    private static final Words SCALE = Words.of("Scale", "Escalar", "Escalar");
    private static final Words SET = Words.of("Set a Value", "Definir um valor", "Definir um valor");
    private static final Words NO_KIND = Words.of(
            "there is no kind '%s': name one as section.kind, such as lights.point or solids.box",
            "não há o tipo '%s': escreva seção.tipo, como lights.point ou solids.box",
            "não há o tipo '%s': escreve secção.tipo, como lights.point ou solids.box");
    private static final Words NO_FIELD = Words.of(
            "what is selected has no value '%s' that a text can give",
            "o que está selecionado não tem um valor '%s' que um texto possa dar",
            "o que está selecionado não tem um valor '%s' que um texto possa dar");
    private static final Words NOT_PERMITTED =
            Words.of("'%s' is not permitted for %s", "'%s' não é permitido em %s", "'%s' não é permitido em %s");

    static final List<EditorAction> ALL = List.of(
            EditorAction.of("add", ADD, Menu.EDIT, List.of("Shift+A"), EntityActions::add)
                    .taking("kind", "at", "id"),
            EditorAction.of("move", MOVE, Menu.EDIT, List.of(), EntityActions::move)
                    .taking("by")
                    .when(EditActions::hasSelection),
            EditorAction.of("turn", TURN, Menu.EDIT, List.of("Ctrl+R"), EntityActions::turn)
                    .taking("axis", "degrees", "pivot")
                    .when(EditActions::hasSelection),
            EditorAction.of("scale", SCALE, Menu.EDIT, List.of(), EntityActions::scale)
                    .taking("by", "pivot")
                    .when(EditActions::hasSelection),
            EditorAction.of("set", SET, Menu.EDIT, List.of(), EntityActions::set)
                    .taking("value", "to")
                    .when(EditActions::hasSelection));

    private EntityActions() {}

    private static void add(ActionCall call) throws ActionFailure {
        if (call.text("kind").isEmpty()) {
            call.desk().show("add");
            return;
        }
        String typed = call.needed("kind");
        Vec3 at = call.vector("at", Vec3.ZERO);
        Document document = call.session().document();
        LevelStructure structure = document.entities().structure();
        for (EntitySection section : structure.lists()) {
            Optional<RecordKind> kind = kind(section.path(), section.kinds(), typed);
            if (kind.isPresent()) {
                String wish = call.text("id").orElse(kind.get().name());
                String id = document.entities().freshId(document.level(), section.path(), wish);
                add(document, section.path(), id, Prototypes.make(kind.get(), id, at));
                return;
            }
        }
        for (SingleSection section : structure.singles()) {
            Optional<RecordKind> kind = kind(section.path(), section.kinds(), typed);
            if (section.isOptional() && kind.isPresent()) {
                add(document, section.path(), "", Prototypes.make(kind.get(), "", at));
                return;
            }
        }
        throw new ActionFailure(NO_KIND.with(typed));
    }

    private static Optional<RecordKind> kind(String path, List<RecordKind> kinds, String typed) {
        if (kinds.size() == 1 && typed.equals(path)) {
            return Optional.of(kinds.get(0));
        }
        return kinds.stream()
                .filter(kind -> typed.equals(path + "." + kind.name()))
                .findFirst();
    }

    private static void add(Document document, String section, String id, Record entity) {
        document.edit(
                ADD,
                null,
                before -> new Snapshot(
                        (Level) document.entities().added(before.level(), section, entity),
                        Selection.of(new EntityRef(section, id))));
    }

    private static void move(ActionCall call) throws ActionFailure {
        Vec3 by = call.vector("by");
        step(
                call,
                MOVE,
                (level, refs) -> EntityTransform.moved(
                        level, refs, by, call.session().options().textureLock()));
    }

    /** Returns the middle of the box around what is selected, on the grid. */
    private static Vec3 pivot(ActionCall call) throws ActionFailure {
        Document document = call.session().document();
        Aabb box = Aabb.EMPTY;
        for (EntityRef ref : document.selection().entities()) {
            Aabb bounds = document.entities()
                    .find(document.level(), ref)
                    .map(EntityBounds::of)
                    .orElse(Aabb.EMPTY);
            box = box.union(bounds);
        }
        Vec3 middle = box.isEmpty() ? Vec3.ZERO : call.session().grid().snapped(box.centre());
        return call.vector("pivot", middle);
    }

    private static void turn(ActionCall call) throws ActionFailure {
        Vec3 axis = call.vector("axis", new Vec3(0, 1, 0));
        double degrees = call.number("degrees", -MOST_DEGREES, MOST_DEGREES, 90);
        Vec3 pivot = pivot(call);
        step(
                call,
                TURN,
                (level, refs) -> EntityTransform.turned(
                        level,
                        refs,
                        pivot,
                        axis,
                        degrees,
                        call.session().options().textureLock()));
    }

    private static void scale(ActionCall call) throws ActionFailure {
        Vec3 factors = call.vector("by");
        Vec3 pivot = pivot(call);
        change(call, SCALE, entity -> EntityTransform.scaled(entity, pivot, factors));
    }

    private static void change(ActionCall call, Words label, UnaryOperator<Record> change) throws ActionFailure {
        Entities entities = call.session().document().entities();
        step(call, label, (level, refs) -> (Level) entities.changed(level, refs, change));
    }

    /** Makes a change of what is selected a step. */
    private static void step(ActionCall call, Words label, BiFunction<Level, List<EntityRef>, Level> change) {
        Document document = call.session().document();
        document.edit(label, level -> change.apply(level, document.selection().entities()));
    }

    private static void set(ActionCall call) throws ActionFailure {
        String name = call.needed("value");
        String text = call.needed("to");
        Document document = call.session().document();
        boolean isKnown = false;
        for (EntityRef ref : document.selection().entities()) {
            Record entity = document.entities().find(document.level(), ref).orElseThrow();
            Optional<RecordField> field = RecordKind.of(entity).field(name).filter(EntityActions::isSettable);
            if (field.isPresent()) {
                isKnown = true;
                if (FieldType.of(field.get()).read(text).isEmpty()) {
                    throw new ActionFailure(NOT_PERMITTED.with(text, name));
                }
            }
        }
        if (!isKnown) {
            throw new ActionFailure(NO_FIELD.with(name));
        }
        change(call, SET, entity -> RecordKind.of(entity)
                .field(name)
                .flatMap(field -> FieldType.of(field).read(text).map(value -> RecordKind.of(entity)
                        .with(entity, field, value)))
                .orElse(entity));
    }

    private static boolean isSettable(RecordField field) {
        return !field.isId()
                && field.kind() != FieldKind.RECORD
                && field.kind() != FieldKind.VARIANT
                && field.kind() != FieldKind.LIST
                && field.kind() != FieldKind.TABLE;
    }
}
