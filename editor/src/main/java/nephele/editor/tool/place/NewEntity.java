package nephele.editor.tool.place;

import java.util.List;
import java.util.Optional;
import nephele.editor.added.AddedRecord;
import nephele.editor.brush.BrushStyle;
import nephele.editor.document.Selection;
import nephele.editor.document.Snapshot;
import nephele.editor.paint.MaterialLibrary;
import nephele.editor.record.Entities;
import nephele.editor.record.EntityRef;
import nephele.editor.record.EntitySection;
import nephele.editor.record.RecordField;
import nephele.editor.record.RecordKind;
import nephele.editor.record.SingleSection;
import nephele.editor.tool.PointedPlace;
import nephele.editor.tool.ToolOptions;
import nephele.engine.level.Body;
import nephele.engine.level.Camera;
import nephele.engine.level.Cloud;
import nephele.engine.level.Level;
import nephele.engine.level.Light;
import nephele.engine.level.PortalSpec;
import nephele.engine.level.Solid;
import nephele.engine.level.Spatial;
import nephele.engine.math.Vec3;

/**
 * An entity at a place on a surface that is not in the level yet.
 *
 * @param section path of its section
 */
record NewEntity(String section, Record entity) {
    /** The distance of a lamp or camera from the surface, so that the surface does not hide it. */
    private static final double SYMBOL_METRES = 0.3;
    /** The height of a cloud's base over the floor that is pointed at: on the floor it would be fog in a room. */
    private static final double CLOUD_BASE_METRES = 60;

    /** Makes the entity that the options name; empty if there is no such kind. */
    static Optional<NewEntity> of(Level level, ToolOptions options, PointedPlace at) {
        String section = options.section();
        return kind(options).map(kind -> {
            String id = Entities.LEVEL.freshId(level, section, wish(options, kind));
            double off = standoffMetres(made(kind, id, at.point(), options, level), at.normal());
            Record record =
                    made(kind, id, PointedPlace.cleaned(at.point().addScaled(off, at.normal())), options, level);
            return new NewEntity(section, record instanceof PortalSpec portal ? on(at, portal) : record);
        });
    }

    private static Optional<RecordKind> kind(ToolOptions options) {
        List<RecordKind> kinds = Entities.LEVEL
                .list(options.section())
                .map(EntitySection::kinds)
                .or(() -> Entities.LEVEL
                        .single(options.section())
                        .filter(SingleSection::isOptional)
                        .map(SingleSection::kinds))
                .orElse(List.of());
        return kinds.size() == 1
                ? Optional.of(kinds.get(0))
                : kinds.stream()
                        .filter(kind -> kind.name().equals(options.kind()))
                        .findFirst();
    }

    /** Returns the kind's name if the section has several, else the section's in the singular. */
    private static String wish(ToolOptions options, RecordKind kind) {
        return Entities.LEVEL
                .list(options.section())
                .filter(list -> list.kinds().size() == 1)
                .map(list -> list.title().replaceFirst("s$", ""))
                .orElse(kind.name());
    }

    private static Record made(RecordKind kind, String id, Vec3 at, ToolOptions options, Level level) {
        Record record = AddedRecord.at(kind, id, at);
        if (record instanceof Solid) {
            return painted(record, options, level);
        }
        return withVariant(kind, record, at, options.kind());
    }

    private static Record painted(Record solid, ToolOptions options, Level level) {
        RecordKind kind = RecordKind.of(solid);
        BrushStyle style = options.style(level);
        Record painted = kind.with(solid, kind.field("material").orElseThrow(), style.material());
        return kind.with(painted, kind.field("portalable").orElseThrow(), style.portalable());
    }

    /** Returns a record whose kind in the file is that of a member, such as a cloud's extent, with the kind wanted. */
    private static Record withVariant(RecordKind kind, Record record, Vec3 at, String wanted) {
        for (RecordField field : kind.fields()) {
            for (Class<?> type : field.declaration().beside() ? field.recordClasses() : List.<Class<?>>of()) {
                RecordKind variant = RecordKind.of(type);
                if (variant.name().equals(wanted)) {
                    return kind.with(record, field, AddedRecord.at(variant, "", at));
                }
            }
        }
        return record;
    }

    /** Returns a portal that looks away from the surface. */
    private static PortalSpec on(PointedPlace at, PortalSpec made) {
        boolean isLevel = Math.abs(at.normal().y()) > 0.999;
        return new PortalSpec(
                made.id(),
                made.linkedTo(),
                made.centre(),
                at.normal(),
                isLevel ? new Vec3(0, 0, -1) : made.up(),
                made.widthMetres(),
                made.heightMetres(),
                made.shape());
    }

    EntityRef ref() {
        return new EntityRef(section, RecordKind.id(entity));
    }

    /** Returns the snapshot with the entity in the level and selected. */
    Snapshot addedTo(Snapshot before) {
        Level base = entity instanceof Solid solid
                ? MaterialLibrary.STANDARD.including(before.level(), solid.material())
                : before.level();
        Level added = AddedRecord.completed(before.level(), Entities.LEVEL.added(base, section, entity));
        Level level = AddedRecord.paired(before.level(), added);
        return new Snapshot(level, Selection.of(ref()));
    }

    /** Returns the distance of an entity's place from the surface on which it stands, along the unit normal. */
    private static double standoffMetres(Record entity, Vec3 normal) {
        double upright = Math.abs(normal.y());
        if (entity instanceof Light || entity instanceof Camera) {
            return SYMBOL_METRES;
        } else if (entity instanceof Body.Sphere sphere) {
            return sphere.radiusMetres();
        } else if (entity instanceof Body.Capsule capsule) {
            return capsule.radiusMetres() + upright * (capsule.heightMetres() / 2 - capsule.radiusMetres());
        } else if (entity instanceof Solid.Prism prism) {
            double level = Math.sqrt(Math.max(0, 1 - upright * upright));
            return level * prism.radiusMetres() + upright * prism.heightMetres() / 2;
        }
        Vec3 size = extent(entity);
        if (entity instanceof Cloud && normal.y() > 0.5) {
            return CLOUD_BASE_METRES + size.y() / 2;
        }
        return (Math.abs(normal.x()) * size.x() + upright * size.y() + Math.abs(normal.z()) * size.z()) / 2;
    }

    private static Vec3 extent(Record entity) {
        Vec3[] found = {Vec3.ZERO};
        RecordKind.mapped(entity, (field, value) -> {
            if (field.spatial() == Spatial.EXTENT && value instanceof Vec3 size) {
                found[0] = size;
            }
            return value;
        });
        return found[0];
    }
}
