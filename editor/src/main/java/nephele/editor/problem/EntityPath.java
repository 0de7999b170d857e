package nephele.editor.problem;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import nephele.editor.document.LevelShapes;
import nephele.editor.record.Entities;
import nephele.editor.record.EntityRef;
import nephele.editor.record.EntitySection;
import nephele.editor.record.RecordKind;
import nephele.engine.level.Brush.BrushFace;
import nephele.engine.level.Level;
import nephele.engine.level.Solid;
import nephele.engine.level.appearance.SolidFaces;

/**
 * The place of an entity, or of a face of a solid, in a level's records, from a JSON path such as {@code environment.clouds[2].size}.
 *
 * @param index in the section's list
 * @param rest the path inside the entity, with its leading dot; empty for the entity itself
 */
record EntityPath(EntitySection section, int index, String rest) {
    private static final Pattern NAMED_FACE = Pattern.compile("\\.faces\\.([^.]+).*");
    private static final Pattern PLANE_FACE = Pattern.compile("\\.(planes\\[(\\d{1,9})\\]).*");
    private static final Pattern ENTRY = Pattern.compile("([A-Za-z.]+)\\[(\\d{1,9})\\](.*)");

    /** Returns the place; empty for a path that leads to no entity of the level. */
    static Optional<EntityPath> of(Level level, String path) {
        Matcher matcher = ENTRY.matcher(path);
        if (!matcher.matches()) {
            return Optional.empty();
        }
        int index = Integer.parseInt(matcher.group(2));
        return Entities.LEVEL
                .list(matcher.group(1))
                .filter(section -> index < section.entities(level).size())
                .map(section -> new EntityPath(section, index, matcher.group(3)));
    }

    /** Returns the entity's name, such as {@code solids/north-wall}. */
    EntityRef reference(Level level) {
        return new EntityRef(section.path(), RecordKind.id(entity(level)));
    }

    /** Returns the entity's record. */
    Record entity(Level level) {
        return section.entities(level).get(index);
    }

    /**
     * Returns a level with another record in an entity's place.
     *
     * @param known the record that is replaced; wherever it is in the list now, by identity
     * @param other {@code null} to delete it
     * @return the same level if the list does not hold it
     */
    Level replaced(Level level, Record known, Record other) {
        List<Record> changed = new ArrayList<>();
        boolean isThere = false;
        for (Record each : section.entities(level)) {
            boolean isIt = each == known && !isThere;
            isThere |= isIt;
            Record kept = isIt ? other : each;
            if (kept != null) {
                changed.add(kept);
            }
        }
        return isThere ? section.with(level, changed) : level;
    }

    /** Returns a level with another record at this place of the list. */
    Level replacedAt(Level level, Record other) {
        List<Record> changed = new ArrayList<>(section.entities(level));
        changed.set(index, other);
        return section.with(level, changed);
    }

    /** Returns the name of the face that the path leads to; empty for the solid itself. */
    private Optional<String> face() {
        Matcher named = NAMED_FACE.matcher(rest);
        Matcher plane = PLANE_FACE.matcher(rest);
        return named.matches()
                ? Optional.of(named.group(1))
                : plane.matches() ? Optional.of(plane.group(1)) : Optional.empty();
    }

    /** Returns the derived face that the path leads to; empty for none. */
    Optional<BrushFace> derivedFace(Level level) {
        if (!(entity(level) instanceof Solid solid)) {
            return Optional.empty();
        }
        String name = face().orElse(null);
        return LevelShapes.brushOf(solid).stream()
                .flatMap(brush -> brush.faces().stream())
                .filter(face -> face.name().equals(name))
                .findFirst();
    }

    /** Returns the solid with the face of the path, or all faces without a value of their own, not portalable. */
    Solid withoutPortals(Solid solid) {
        Boolean refusal = solid.portalable() ? Boolean.FALSE : null;
        return changed(
                solid,
                authored -> new Solid.Face(authored.material(), refusal, authored.texture()),
                whole -> RecordKind.with(whole, "portalable", false));
    }

    /** Returns the solid with a material on the face of the path, or on all faces without one of their own. */
    Solid withMaterial(Solid solid, String material) {
        return changed(
                solid,
                authored -> new Solid.Face(material, authored.portalable(), authored.texture()),
                whole -> RecordKind.with(whole, "material", material));
    }

    /** A solid of which the path names a face that it has not stays as it is. */
    private Solid changed(Solid solid, UnaryOperator<Solid.Face> ofFace, UnaryOperator<Record> ofSolid) {
        String name = face().orElse("");
        if (name.isEmpty()) {
            return (Solid) ofSolid.apply((Record) solid);
        }
        return SolidFaces.names(solid).contains(name)
                ? SolidFaces.with(solid, name, ofFace.apply(SolidFaces.authored(solid, name)))
                : solid;
    }
}
