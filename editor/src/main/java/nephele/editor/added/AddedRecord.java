package nephele.editor.added;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import nephele.editor.document.EntityTransform;
import nephele.editor.paint.MaterialLibrary;
import nephele.editor.record.Entities;
import nephele.editor.record.EntityRef;
import nephele.editor.record.EntitySection;
import nephele.editor.record.FieldKind;
import nephele.editor.record.RecordField;
import nephele.editor.record.RecordKind;
import nephele.engine.level.Billboards;
import nephele.engine.level.BoxFace;
import nephele.engine.level.Environment.Lightning;
import nephele.engine.level.Exposure;
import nephele.engine.level.Level;
import nephele.engine.level.ModelPlacement;
import nephele.engine.level.PlayerStart;
import nephele.engine.level.PortalSpec;
import nephele.engine.level.Sky;
import nephele.engine.level.SkyboxLayout;
import nephele.engine.level.Solid;
import nephele.engine.level.Spatial;
import nephele.engine.math.Vec3;

/**
 * A record that is added to a level: it is made at a place from its declaration, and the level is given what it needs. A
 * reference names a record that exists, an observer has a camera and a player, billboards are at places or over a field
 * but not both, a field of models is of impostors, a sky in one picture has no second one.
 */
public final class AddedRecord {
    private static final String MATERIALS = "materials";
    private static final double HALF_METRES = 0.5;

    private final Level before;

    private AddedRecord(Level before) {
        this.before = before;
    }

    /** Returns a new record at a place, metres; a record without an id ignores it. */
    public static Record at(RecordKind kind, String id, Vec3 at) {
        Record record = declared(kind, id, at);
        if (record instanceof ModelPlacement) {
            return at.equals(Vec3.ZERO) ? record : EntityTransform.moved(record, at);
        } else if (record instanceof Solid.Planes planes) {
            return cube(planes, at);
        }
        return record instanceof Lightning lightning ? above(lightning) : record;
    }

    /** Planes without a single one enclose nothing. */
    private static Record cube(Solid.Planes none, Vec3 at) {
        Vec3 centre = at.plus(new Vec3(0, HALF_METRES, 0));
        List<Solid.PlaneFace> planes = List.of(BoxFace.values()).stream()
                .map(side ->
                        new Solid.PlaneFace(side.normal(), side.normal().dot(centre) + HALF_METRES, null, null, null))
                .toList();
        return new Solid.Planes(none.id(), none.material(), none.portalable(), none.textureMapping(), planes);
    }

    /** Bolts end below the box in which they begin. */
    private static Record above(Lightning lightning) {
        double up = lightning.groundAltitudeMetres()
                + 2 * lightning.size().y()
                - lightning.centre().y();
        return up > 0 ? EntityTransform.moved(lightning, new Vec3(0, up, 0)) : lightning;
    }

    /** Returns the record of the absent values, prototypes and places that its components declare. */
    private static Record declared(RecordKind kind, String id, Vec3 at) {
        Object[] values = new Object[kind.fields().size()];
        boolean isTarget = false;
        for (RecordField field : kind.fields()) {
            Object value = value(field, id, at);
            if (field.spatial() == Spatial.POINT && field.isRequired()) {
                // Two equal points, such as a camera's position and target, would give no direction.
                value = isTarget ? at.plus(new Vec3(0, 0, -1)) : at;
                isTarget = true;
            }
            if (field.spatial() == Spatial.POINT && field.kind() == FieldKind.LIST) {
                value = List.of(at);
            }
            values[field.index()] = value;
        }
        return kind.make(values);
    }

    private static Object value(RecordField field, String id, Vec3 at) {
        if (field.isId()) {
            return id;
        }
        if (!field.isRequired() && field.written().prototype() == null) {
            return field.declaration().beside()
                    ? nested(field, id, at)
                    : field.written().absent();
        }
        return field.written().prototype() != null ? field.written().prototype() : derived(field, id, at);
    }

    private static Record nested(RecordField field, String id, Vec3 at) {
        List<Class<?>> classes = field.recordClasses();
        return declared(RecordKind.of(classes.get(classes.size() - 1)), id, at);
    }

    private static Object derived(RecordField field, String id, Vec3 at) {
        double number = field.range() == null ? 1 : field.range().nearest(1);
        return switch (field.kind()) {
            case NUMBER -> number;
            case WHOLE -> field.valueClass() == int.class ? (Object) (int) number : (Object) (long) number;
            case TRUTH -> false;
            case TEXT, REFERENCE, ASSET -> id.isEmpty() ? "new" : id;
            case CHOICE -> field.choices().get(0);
            case VECTOR -> field.spatial() == Spatial.DIRECTION ? new Vec3(0, 1, 0) : new Vec3(number, number, number);
            case EXPOSURE -> Exposure.NEUTRAL;
            case RECORD, VARIANT -> nested(field, id, at);
            case LIST -> List.of();
            case TABLE -> Map.of();
        };
    }

    /** Returns the level after an addition, completed; what was wrong before stays as it was. */
    public static Level completed(Level before, Level after) {
        return before.equals(after) ? after : new AddedRecord(before).complete(after);
    }

    private Level complete(Level added) {
        Level level = observed(planted(framed(added)));
        for (EntitySection section : Entities.LEVEL.lists()) {
            level = referring(level, section);
        }
        return level;
    }

    private static Level added(Level level, String section, String wish, Vec3 at) {
        EntitySection list = Entities.LEVEL.list(section).orElseThrow();
        String id = Entities.LEVEL.freshId(level, section, wish);
        return Entities.LEVEL.added(level, section, at(list.kinds().get(0), id, at));
    }

    private Level framed(Level level) {
        if (!(level.environment().sky() instanceof Sky.Skybox box)
                || box.equals(before.environment().sky())
                || box.layout() != SkyboxLayout.CROSS
                || box.files().size() < 2) {
            return level;
        }
        Sky framed = new Sky.Skybox(box.layout(), box.files().subList(0, 1), box.whiteRadiance());
        return Entities.LEVEL.changed(level, List.of(EntityRef.single("environment.sky")), sky -> (Record) framed);
    }

    /** Returns the level after an addition with a new portal that leads to itself joined with another one that does. */
    public static Level paired(Level before, Level level) {
        List<PortalSpec> alone = level.portals().stream()
                .filter(portal -> portal.linkedTo().equals(portal.id()))
                .toList();
        if (alone.size() < 2 || level.portals().size() <= before.portals().size()) {
            return level;
        }
        PortalSpec made = alone.get(alone.size() - 1);
        return linked(linked(level, made, alone.get(0)), alone.get(0), made);
    }

    private static Level linked(Level level, PortalSpec portal, PortalSpec partner) {
        RecordKind kind = RecordKind.of(portal);
        return Entities.LEVEL.changed(
                level,
                List.of(new EntityRef("portals", portal.id())),
                entity -> kind.with(entity, kind.field("linkedTo").orElseThrow(), partner.id()));
    }

    private Level observed(Level level) {
        if (level.observer() == null || before.observer() != null) {
            return level;
        }
        Level result = level.cameras().isEmpty() ? added(level, "cameras", "camera", new Vec3(0, 2, 8)) : level;
        RecordKind player = RecordKind.of(PlayerStart.class);
        return result.player() != null ? result : Entities.LEVEL.added(result, "player", at(player, "", Vec3.ZERO));
    }

    private Level planted(Level level) {
        List<Billboards> all = new ArrayList<>(level.billboards());
        all.replaceAll(each -> each.field() != null
                        && !each.at().isEmpty()
                        && !before.billboards().contains(each)
                ? each.over(each.field(), each.heightVariation(), each.windMetresPerSecond())
                : each);
        Level result = all.equals(level.billboards()) ? level : level.withBillboards(List.copyOf(all));
        List<EntityRef> fields = level.models().stream()
                .filter(model -> model.isPlanted()
                        && !model.impostor()
                        && !before.models().contains(model))
                .map(model -> new EntityRef("models", model.id()))
                .toList();
        return Entities.LEVEL.changed(result, fields, model -> ((ModelPlacement) model).asImpostor());
    }

    /** Makes new references to a section name records of it; an optional one with nothing to name is absent. */
    private Level referring(Level level, EntitySection section) {
        Set<String> wrong = new HashSet<>(Entities.references(level, section.path()));
        wrong.removeAll(Entities.references(before, section.path()));
        wrong.removeAll(ids(level, section));
        if (wrong.isEmpty()) {
            return level;
        }
        boolean isBare = section.path().equals(MATERIALS) && level.materials().isEmpty();
        Level able = isBare ? MaterialLibrary.STANDARD.including(level, MaterialLibrary.FIRST) : level;
        Level result = able;
        for (EntitySection owners : Entities.LEVEL.lists()) {
            List<Record> changed = owners.entities(result).stream()
                    .map(owner -> referring(owner, section.path(), wrong, others(able, section, owners, owner)))
                    .toList();
            result = changed.equals(owners.entities(result)) ? result : owners.with(result, changed);
        }
        return referring(result, section.path(), wrong, ids(able, section));
    }

    private static <R extends Record> R referring(R owner, String section, Set<String> wrong, List<String> ids) {
        return RecordKind.mapped(owner, (field, value) -> {
            boolean isWrong = field.declaration().refersTo().equals(section) && value != null && wrong.contains(value);
            return !isWrong || ids.isEmpty() && field.isRequired() ? value : ids.isEmpty() ? null : ids.get(0);
        });
    }

    /** Returns the ids that a record can name: not its own. */
    private static List<String> others(Level level, EntitySection section, EntitySection owners, Record owner) {
        List<String> ids = new ArrayList<>(ids(level, section));
        if (owners.equals(section)) {
            ids.remove(RecordKind.id(owner));
        }
        return ids;
    }

    private static List<String> ids(Level level, EntitySection section) {
        return section.entities(level).stream().map(RecordKind::id).toList();
    }
}
