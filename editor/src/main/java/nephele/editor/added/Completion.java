package nephele.editor.added;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import nephele.editor.paint.MaterialLibrary;
import nephele.editor.record.Entities;
import nephele.editor.record.EntityRef;
import nephele.editor.record.EntitySection;
import nephele.editor.record.RecordKind;
import nephele.engine.level.Billboards;
import nephele.engine.level.Level;
import nephele.engine.level.ModelPlacement;
import nephele.engine.level.PlayerStart;
import nephele.engine.level.PortalSpec;
import nephele.engine.level.Sky;
import nephele.engine.level.SkyboxLayout;
import nephele.engine.math.Vec3;

/**
 * Gives a level what a record that was just added to it needs: a reference names a record that exists, an observer has a
 * camera and a player, billboards are at places or over a field but not both, a field of models is
 * of impostors, a sky in one picture has no second one.
 */
public final class Completion {
    private static final String MATERIALS = "materials";

    private final Level before;

    private Completion(Level before) {
        this.before = before;
    }

    /** Returns the level after an addition, completed; what was wrong before stays as it was. */
    public static Level of(Level before, Level after) {
        return before.equals(after) ? after : new Completion(before).complete(after);
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
        return (Level)
                Entities.LEVEL.added(level, section, NewRecord.at(list.kinds().get(0), id, at));
    }

    private Level framed(Level level) {
        if (!(level.environment().sky() instanceof Sky.Skybox box)
                || box.equals(before.environment().sky())
                || box.layout() != SkyboxLayout.CROSS
                || box.files().size() < 2) {
            return level;
        }
        Sky framed = new Sky.Skybox(box.layout(), box.files().subList(0, 1), box.whiteRadiance());
        return (Level)
                Entities.LEVEL.changed(level, List.of(EntityRef.single("environment.sky")), sky -> (Record) framed);
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
        return (Level) Entities.LEVEL.changed(
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
        return result.player() != null
                ? result
                : (Level) Entities.LEVEL.added(result, "player", NewRecord.at(player, "", Vec3.ZERO));
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
        return (Level) Entities.LEVEL.changed(result, fields, model -> ((ModelPlacement) model).asImpostor());
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
        Record result = able;
        for (EntitySection owners : Entities.LEVEL.lists()) {
            List<Record> changed = owners.entities(result).stream()
                    .map(owner -> referring(owner, section.path(), wrong, others(able, section, owners, owner)))
                    .toList();
            result = changed.equals(owners.entities(result)) ? result : owners.with(result, changed);
        }
        return (Level) referring(result, section.path(), wrong, ids(able, section));
    }

    private static Record referring(Record owner, String section, Set<String> wrong, List<String> ids) {
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
