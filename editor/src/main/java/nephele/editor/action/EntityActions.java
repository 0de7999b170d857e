package nephele.editor.action;

import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import nephele.editor.action.EditorAction.Menu;
import nephele.editor.action.EditorAction.Subject;
import nephele.editor.added.AddedRecord;
import nephele.editor.brush.BrushEdit;
import nephele.editor.brush.LockableTransform;
import nephele.editor.brush.SolidTransform;
import nephele.editor.document.Document;
import nephele.editor.document.EntityBounds;
import nephele.editor.document.EntityTransform;
import nephele.editor.document.Selection;
import nephele.editor.document.Snapshot;
import nephele.editor.panel.model.FieldType;
import nephele.editor.record.Entities;
import nephele.editor.record.EntityRef;
import nephele.editor.record.EntitySection;
import nephele.editor.record.FieldKind;
import nephele.editor.record.RecordField;
import nephele.editor.record.RecordKind;
import nephele.editor.record.SingleSection;
import nephele.editor.text.EditorRefusal;
import nephele.editor.text.Words;
import nephele.engine.level.Level;
import nephele.engine.level.Solid;
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
    private static final Words NO_AXIS = Words.of(
            "axis must not be 0,0,0: give a direction, such as 0,1,0",
            "axis não pode ser 0,0,0: dê uma direção, como 0,1,0",
            "axis não pode ser 0,0,0: dá uma direção, como 0,1,0");
    private static final Words FLAT = Words.of(
            "by must not have a 0: a factor of 1 keeps a size",
            "by não pode ter um 0: o fator 1 mantém o tamanho",
            "by não pode ter um 0: o fator 1 mantém o tamanho");
    private static final Words NOT_PERMITTED =
            Words.of("'%s' is not permitted for %s", "'%s' não é permitido em %s", "'%s' não é permitido em %s");

    static final List<EditorAction> ALL = List.of(
            EditorAction.of("add", ADD, Menu.EDIT, List.of("Shift+A"), EntityActions::add)
                    .taking("kind", "at", "id")
                    .changing(Subject.LEVEL),
            EditorAction.of("move", MOVE, Menu.EDIT, List.of(), EntityActions::move)
                    .taking("by")
                    .changing(Subject.LEVEL)
                    .when(EditActions::hasSelection),
            EditorAction.of("turn", TURN, Menu.EDIT, List.of("Ctrl+R"), EntityActions::turn)
                    .taking("axis", "degrees", "pivot")
                    .changing(Subject.LEVEL)
                    .when(EditActions::hasSelection),
            EditorAction.of("scale", SCALE, Menu.EDIT, List.of(), EntityActions::scale)
                    .taking("by", "pivot")
                    .changing(Subject.LEVEL)
                    .when(EditActions::hasSelection),
            EditorAction.of("set", SET, Menu.EDIT, List.of(), EntityActions::set)
                    .taking("value", "to")
                    .changing(Subject.LEVEL)
                    .when(EditActions::hasSelection));

    private EntityActions() {}

    private static void add(ActionCall call) throws EditorRefusal {
        if (!call.isGiven("kind", "add")) {
            return;
        }
        String typed = call.needed("kind");
        Vec3 at = call.vector("at", Vec3.ZERO);
        Document document = call.session().document();
        for (EntitySection section : Entities.LEVEL.lists()) {
            Optional<RecordKind> kind = kind(section.path(), section.kinds(), typed);
            if (kind.isPresent()) {
                String wish = call.text("id").orElse(kind.get().name());
                String id = Entities.LEVEL.freshId(document.level(), section.path(), wish);
                add(document, section.path(), id, AddedRecord.at(kind.get(), id, at));
                return;
            }
        }
        for (SingleSection section : Entities.LEVEL.singles()) {
            Optional<RecordKind> kind = kind(section.path(), section.kinds(), typed);
            if (section.isOptional() && kind.isPresent()) {
                add(document, section.path(), "", AddedRecord.at(kind.get(), "", at));
                return;
            }
        }
        throw new EditorRefusal(NO_KIND.with(typed));
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
                        AddedRecord.completed(before.level(), Entities.LEVEL.added(before.level(), section, entity)),
                        Selection.of(new EntityRef(section, id))));
    }

    private static void move(ActionCall call) throws EditorRefusal {
        Vec3 by = call.vector("by");
        step(
                call,
                MOVE,
                (level, refs) -> EntityTransform.moved(
                        level, refs, by, call.session().options().isTextureLocked()));
    }

    /** Returns the middle of the box around what is selected, on the grid. */
    private static Vec3 pivot(ActionCall call) throws EditorRefusal {
        Document document = call.session().document();
        Aabb box = EntityBounds.of(document.level(), document.selection().entities());
        Vec3 middle = box.isEmpty() ? Vec3.ZERO : call.session().grid().snapped(box.centre());
        return call.vector("pivot", middle);
    }

    private static void turn(ActionCall call) throws EditorRefusal {
        Vec3 axis = axis(call);
        double degrees = call.number("degrees", -MOST_DEGREES, MOST_DEGREES, 90);
        Vec3 pivot = pivot(call);
        boolean isTextureLocked = call.session().options().isTextureLocked();
        LockableTransform solids = LockableTransform.of(
                isTextureLocked, call.session().document().level().materials());
        requireEach(call, solid -> solids.rotated(solid, pivot, axis, degrees));
        step(call, TURN, (level, refs) -> EntityTransform.turned(level, refs, pivot, axis, degrees, isTextureLocked));
    }

    /** Returns the axis to turn about, of a length that can be squared. */
    private static Vec3 axis(ActionCall call) throws EditorRefusal {
        Vec3 axis = call.vector("axis", new Vec3(0, 1, 0));
        double greatest = Math.max(Math.abs(axis.x()), Math.max(Math.abs(axis.y()), Math.abs(axis.z())));
        if (greatest == 0) {
            throw new EditorRefusal(NO_AXIS);
        }
        return greatest > 1e-100 && greatest < 1e100
                ? axis
                : new Vec3(axis.x() / greatest, axis.y() / greatest, axis.z() / greatest);
    }

    /** Refuses an edit that one of the selected solids does not take, which would stay behind without a word. */
    private static void requireEach(ActionCall call, Function<Solid, BrushEdit<?>> edit) throws EditorRefusal {
        Document document = call.session().document();
        for (EntityRef ref : EditActions.unlocked(call)) {
            if (Entities.LEVEL.find(document.level(), ref).orElseThrow() instanceof Solid solid) {
                BrushActions.done(edit.apply(solid));
            }
        }
    }

    private static void scale(ActionCall call) throws EditorRefusal {
        Vec3 factors = call.vector("by");
        if (factors.x() == 0 || factors.y() == 0 || factors.z() == 0) {
            throw new EditorRefusal(FLAT);
        }
        Vec3 pivot = pivot(call);
        requireEach(call, solid -> SolidTransform.scaled(solid, pivot, factors));
        change(call, SCALE, entity -> EntityTransform.scaled(entity, pivot, factors));
    }

    private static void change(ActionCall call, Words label, UnaryOperator<Record> change) throws EditorRefusal {
        step(call, label, (level, refs) -> Entities.LEVEL.changed(level, refs, change));
    }

    /** Makes a change of what is selected a step. */
    private static void step(ActionCall call, Words label, BiFunction<Level, List<EntityRef>, Level> change)
            throws EditorRefusal {
        Document document = call.session().document();
        List<EntityRef> refs = EditActions.unlocked(call);
        document.edit(label, level -> change.apply(level, refs));
    }

    private static void set(ActionCall call) throws EditorRefusal {
        String name = call.needed("value");
        String text = call.needed("to");
        Document document = call.session().document();
        boolean isKnown = false;
        for (EntityRef ref : document.selection().entities()) {
            Record entity = Entities.LEVEL.find(document.level(), ref).orElseThrow();
            Optional<RecordField> field = RecordKind.of(entity).field(name).filter(EntityActions::isSettable);
            if (field.isPresent()) {
                isKnown = true;
                if (FieldType.of(field.get()).read(text).isEmpty()) {
                    throw new EditorRefusal(NOT_PERMITTED.with(text, name));
                }
            }
        }
        if (!isKnown) {
            throw new EditorRefusal(NO_FIELD.with(name));
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
