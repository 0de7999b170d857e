package nephele.editor.tool.place;

import java.util.List;
import java.util.Optional;
import nephele.editor.brush.BrushStyle;
import nephele.editor.document.Selection;
import nephele.editor.document.Snapshot;
import nephele.editor.paint.MaterialLibrary;
import nephele.editor.record.Entities;
import nephele.editor.record.EntityRef;
import nephele.editor.record.EntitySection;
import nephele.editor.record.LevelStructure;
import nephele.editor.record.Prototypes;
import nephele.editor.record.RecordField;
import nephele.editor.record.RecordKind;
import nephele.editor.record.SingleSection;
import nephele.editor.tool.PointedPlace;
import nephele.editor.tool.ToolOptions;
import nephele.editor.transform.EntityTransform;
import nephele.engine.level.BoxFace;
import nephele.engine.level.Level;
import nephele.engine.level.ModelPlacement;
import nephele.engine.level.PortalSpec;
import nephele.engine.level.Solid;
import nephele.engine.math.Vec3;

/**
 * An entity at a place on a surface that is not in the level yet.
 *
 * @param section path of its section
 */
record NewEntity(String section, Record entity) {
    private static final double HALF_METRES = 0.5;

    /** Makes the entity that the options name; empty if there is no such kind. */
    static Optional<NewEntity> of(Level level, Entities entities, ToolOptions options, PointedPlace at) {
        String section = options.section();
        return kind(entities.structure(), options).map(kind -> {
            String id = entities.freshId(level, section, wish(entities.structure(), options, kind));
            double off = Standoff.metres(made(kind, id, at.point(), options, level), at.normal());
            Record record =
                    made(kind, id, PointedPlace.cleaned(at.point().addScaled(off, at.normal())), options, level);
            return new NewEntity(section, record instanceof PortalSpec portal ? on(at, portal, level) : record);
        });
    }

    private static Optional<RecordKind> kind(LevelStructure structure, ToolOptions options) {
        List<RecordKind> kinds = structure
                .list(options.section())
                .map(EntitySection::kinds)
                .or(() -> structure
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
    private static String wish(LevelStructure structure, ToolOptions options, RecordKind kind) {
        return structure
                .list(options.section())
                .filter(list -> list.kinds().size() == 1)
                .map(list -> list.title().replaceFirst("s$", ""))
                .orElse(kind.name());
    }

    private static Record made(RecordKind kind, String id, Vec3 at, ToolOptions options, Level level) {
        Record record = Prototypes.make(kind, id, at);
        if (record instanceof ModelPlacement) {
            return at.equals(Vec3.ZERO) ? record : EntityTransform.moved(record, at);
        } else if (record instanceof Solid solid) {
            return painted(solid instanceof Solid.Planes planes ? cube(planes, at) : record, options, level);
        }
        return withVariant(kind, record, at, options.kind());
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
                    return kind.with(record, field, Prototypes.make(variant, "", at));
                }
            }
        }
        return record;
    }

    /** Returns a portal that looks away from the surface and leads to one that has no partner yet, or to itself. */
    private static PortalSpec on(PointedPlace at, PortalSpec made, Level level) {
        boolean isLevel = Math.abs(at.normal().y()) > 0.999;
        return new PortalSpec(
                made.id(),
                alone(level).map(PortalSpec::id).orElse(made.id()),
                made.centre(),
                at.normal(),
                isLevel ? new Vec3(0, 0, -1) : made.up(),
                made.widthMetres(),
                made.heightMetres(),
                made.shape());
    }

    private static Optional<PortalSpec> alone(Level level) {
        return level.portals().stream()
                .filter(portal -> portal.linkedTo().equals(portal.id()))
                .findFirst();
    }

    EntityRef ref() {
        return new EntityRef(section, RecordKind.id(entity));
    }

    /** Returns the snapshot with the entity in the level and selected. */
    Snapshot addedTo(Snapshot before, Entities entities) {
        Level base = entity instanceof Solid solid
                ? MaterialLibrary.STANDARD.including(before.level(), solid.material())
                : before.level();
        Level level = (Level) entities.added(base, section, entity);
        if (entity instanceof PortalSpec portal && !portal.linkedTo().equals(portal.id())) {
            level = (Level) entities.changed(
                    level,
                    List.of(new EntityRef(section, portal.linkedTo())),
                    other -> linked((PortalSpec) other, portal.id()));
        }
        return new Snapshot(level, Selection.of(ref()));
    }

    private static PortalSpec linked(PortalSpec portal, String id) {
        return new PortalSpec(
                portal.id(),
                id,
                portal.centre(),
                portal.normal(),
                portal.up(),
                portal.widthMetres(),
                portal.heightMetres(),
                portal.shape());
    }
}
