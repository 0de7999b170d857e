package nephele.editor.problem;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.UnaryOperator;
import nephele.editor.document.EntityTransform;
import nephele.editor.document.NoteEdits;
import nephele.editor.record.Entities;
import nephele.editor.record.EntityRef;
import nephele.editor.record.RecordField;
import nephele.editor.record.RecordKind;
import nephele.engine.level.Brush.BrushFace;
import nephele.engine.level.Level;
import nephele.engine.level.Material;
import nephele.engine.level.Problem;
import nephele.engine.level.Problem.Topic;
import nephele.engine.level.Solid;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/** The remedies for the rules' problems. Each finds its records in the level that it is applied to by identity. */
final class ProblemFixes {
    private static final String MATERIALS = "materials";
    private static final Vec3 LIGHT_GREY = new Vec3(0.5, 0.5, 0.5);

    private final Level level;
    private final StaticShapes statics;

    /** @param statics {@code null} if they cannot be derived */
    ProblemFixes(Level level, StaticShapes statics) {
        this.level = level;
        this.statics = statics;
    }

    List<LevelProblem.Fix> of(Problem problem) {
        Topic topic = problem.subject().topic();
        Optional<EntityPath> place = EntityPath.of(level, problem.path());
        if (problem.path().startsWith("player") && topic == Topic.ENTITY_IN_SOLID) {
            return moveStart();
        } else if (problem.path().startsWith("environment.sky") && topic == Topic.MISSING_ASSET) {
            return List.of(new LevelProblem.Fix(ProblemText.REMOVE_FILE.words(), ProblemFixes::withoutSky));
        } else if (place.isEmpty()) {
            return List.of();
        }
        return of(topic, place.get(), problem);
    }

    private List<LevelProblem.Fix> of(Topic topic, EntityPath place, Problem problem) {
        switch (topic) {
            case DUPLICATE_ID:
                return List.of(rename(place));
            case MISSING_MATERIAL:
                return missingMaterial(place);
            case MISSING_ASSET:
                return List.of(withoutFile(place));
            case NO_VOLUME:
            case TOO_THIN:
            case INSIDE_ANOTHER:
            case LIGHT_WITHOUT_EFFECT:
                return List.of(delete(place));
            case FIGHTING_FACES:
                return oneMaterial(problem);
            case TOO_SMALL_FOR_PORTAL:
                return List.of(withoutPortals(problem));
            case ENTITY_IN_SOLID:
                return moveOut(place);
            case GENERAL:
            case NO_VIEWPOINT:
            case LEAK:
                return List.of();
        }
        throw new IllegalStateException("no case for " + topic);
    }

    private LevelProblem.Fix delete(EntityPath place) {
        Record known = place.entity(level);
        EntityRef ref = place.reference(level);
        return new LevelProblem.Fix(ProblemText.DELETE.with(ref.id()), now -> {
            Level without = place.replaced(now, known, null);
            // The notes stay if another entity has the same id.
            boolean isLast = Entities.LEVEL.find(without, ref).isEmpty();
            return isLast ? NoteEdits.without(without, List.of(ref)) : without;
        });
    }

    private LevelProblem.Fix replace(ProblemText text, EntityPath place, Record other) {
        Record known = place.entity(level);
        return new LevelProblem.Fix(text.words(), now -> place.replaced(now, known, other));
    }

    private LevelProblem.Fix rename(EntityPath place) {
        Record record = place.entity(level);
        String name = Entities.LEVEL.freshId(level, place.section().path(), RecordKind.id(record));
        Record renamed = Entities.withId(record, name);
        // Duplicates may be one object, so that only the place tells them apart.
        return new LevelProblem.Fix(ProblemText.RENAME.with(name), now -> renamedLast(place, now, record, renamed));
    }

    private static Level renamedLast(EntityPath place, Level now, Record record, Record renamed) {
        List<Record> list = place.section().entities(now);
        boolean isThere = place.index() < list.size() && list.get(place.index()) == record;
        return isThere ? place.replacedAt(now, renamed) : now;
    }

    private List<LevelProblem.Fix> missingMaterial(EntityPath place) {
        Set<String> known = new HashSet<>();
        level.materials().forEach(material -> known.add(material.id()));
        Record entity = place.entity(level);
        Set<String> missing = Entities.references(entity, MATERIALS);
        missing.removeAll(known);
        LevelProblem.Fix create = new LevelProblem.Fix(
                ProblemText.CREATE_MATERIAL.with(String.join(", ", missing)), now -> withMaterials(now, missing));
        return List.of(
                create,
                replace(
                        ProblemText.USE_NO_MATERIAL,
                        place,
                        Entities.withReferences(entity, MATERIALS, id -> known.contains(id) ? id : null)));
    }

    private static Level withMaterials(Level now, Set<String> missing) {
        Set<String> wanted = new TreeSet<>(missing);
        now.materials().forEach(material -> wanted.remove(material.id()));
        List<Material> materials = new ArrayList<>(now.materials());
        wanted.forEach(id -> materials.add(new Material(id, LIGHT_GREY, null, null, null, null, Vec3.ZERO, 1)));
        return wanted.isEmpty() ? now : now.with(List.copyOf(materials), now.solids());
    }

    /** Leaves an optional file out; a record that is nothing without its file is deleted. */
    private LevelProblem.Fix withoutFile(EntityPath place) {
        String path = place.rest().substring(Math.min(1, place.rest().length()));
        return without(place.entity(level), path)
                .map(other -> replace(ProblemText.REMOVE_FILE, place, other))
                .orElseGet(() -> delete(place));
    }

    /** Returns a record without one of its optional values; empty if the path leads to none. */
    private static Optional<Record> without(Record record, String path) {
        RecordKind kind = RecordKind.of(record);
        int dot = path.indexOf('.');
        if (dot < 0) {
            return kind.field(path).filter(RecordField::isNullable).map(field -> kind.with(record, field, null));
        }
        Optional<RecordField> part = kind.field(path.substring(0, dot));
        return part.map(field -> kind.get(record, field))
                .filter(Record.class::isInstance)
                .flatMap(nested -> without((Record) nested, path.substring(dot + 1)))
                .map(changed -> kind.with(record, part.get(), changed));
    }

    private static Level withoutSky(Level now) {
        return Entities.LEVEL.without(now, List.of(EntityRef.single("environment.sky")));
    }

    private LevelProblem.Fix withoutPortals(Problem problem) {
        List<UnaryOperator<Level>> changes = new ArrayList<>();
        for (String path : paths(problem)) {
            EntityPath.of(level, path).ifPresent(place -> changes.add(now -> refusing(now, place)));
        }
        return new LevelProblem.Fix(ProblemText.TAKE_NO_PORTALS.words(), now -> {
            Level changed = now;
            for (UnaryOperator<Level> change : changes) {
                changed = change.apply(changed);
            }
            return changed;
        });
    }

    /** Finds the solid by its place, because another face of it may have been changed just before. */
    private static Level refusing(Level now, EntityPath place) {
        if (place.index() >= now.solids().size()) {
            return now;
        }
        Solid solid = now.solids().get(place.index());
        Solid changed = place.withoutPortals(solid);
        return changed.equals(solid) ? now : place.replacedAt(now, (Record) changed);
    }

    private static List<String> paths(Problem problem) {
        List<String> paths = new ArrayList<>(List.of(problem.path()));
        paths.addAll(problem.subject().otherPaths());
        return paths;
    }

    /** Offers both materials; the default grey cannot be given to a face, so that one has only the other. */
    private List<LevelProblem.Fix> oneMaterial(Problem problem) {
        List<LevelProblem.Fix> fixes = new ArrayList<>();
        List<String> paths = paths(problem);
        for (int i = 0; i < 2 && paths.size() == 2; i++) {
            Optional<EntityPath> to = EntityPath.of(level, paths.get(i));
            Optional<EntityPath> from = EntityPath.of(level, paths.get(1 - i));
            String material = from.flatMap(this::material).orElse(null);
            if (to.isPresent() && material != null && to.get().entity(level) instanceof Solid solid) {
                EntityPath place = to.get();
                Solid changed = place.withMaterial(solid, material);
                fixes.add(new LevelProblem.Fix(
                        ProblemText.ONE_MATERIAL.with(material),
                        now -> place.replaced(now, (Record) solid, (Record) changed)));
            }
        }
        return fixes;
    }

    private Optional<String> material(EntityPath place) {
        Optional<String> ofFace = place.derivedFace(level).map(BrushFace::material);
        return ofFace.isPresent() || !(place.entity(level) instanceof Solid solid)
                ? ofFace
                : Optional.ofNullable(solid.material());
    }

    private List<LevelProblem.Fix> moveOut(EntityPath place) {
        Record entity = place.entity(level);
        Aabb box = FreePlace.room(entity);
        if (box.isEmpty() || statics == null) {
            return List.of(delete(place));
        }
        LevelProblem.Fix move =
                new LevelProblem.Fix(ProblemText.MOVE_OUT.words(), now -> new FreePlace(level, statics, entity)
                        .nearest(box)
                        .map(displacement -> place.replaced(now, entity, EntityTransform.moved(entity, displacement)))
                        .orElse(now));
        return List.of(move, delete(place));
    }

    private List<LevelProblem.Fix> moveStart() {
        Record start = level.player();
        if (statics == null) {
            return List.of();
        }
        return List.of(new LevelProblem.Fix(ProblemText.MOVE_OUT.words(), now -> new FreePlace(level, statics, start)
                .nearest(FreePlace.room(start))
                .filter(displacement -> now.player() == start)
                .map(displacement -> RecordKind.with(now, "player", EntityTransform.moved(start, displacement)))
                .orElse(now)));
    }
}
