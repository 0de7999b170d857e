package nephele.editor.problem;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import nephele.engine.level.BoxFace;
import nephele.engine.level.Brush;
import nephele.engine.level.Brush.BrushFace;
import nephele.engine.level.Level;
import nephele.engine.level.Solid;

/** Changes of a face's material and portalability, by the path of its record; without one, of the whole solid. */
final class FaceEdit {
    private static final Pattern BOX_OR_WEDGE = Pattern.compile("\\.faces\\.([^.]+).*");
    private static final Pattern PLANE = Pattern.compile("\\.(planes\\[(\\d{1,9})\\]).*");

    private FaceEdit() {}

    /** Returns the name of the face that a path leads to; empty for the solid itself. */
    static Optional<String> face(String rest) {
        Matcher box = BOX_OR_WEDGE.matcher(rest);
        Matcher plane = PLANE.matcher(rest);
        return box.matches()
                ? Optional.of(box.group(1))
                : plane.matches() ? Optional.of(plane.group(1)) : Optional.empty();
    }

    /** Returns the derived face that a path leads to; empty for none. */
    static Optional<BrushFace> derived(Level level, EntityPath place) {
        if (!(place.entity(level) instanceof Solid solid)) {
            return Optional.empty();
        }
        String name = face(place.rest()).orElse(null);
        return Brush.of(solid).faces().stream()
                .filter(face -> face.name().equals(name))
                .findFirst();
    }

    /** Returns the solid with a face, or all that say nothing, not portalable. */
    static Solid withoutPortals(Solid solid, String rest) {
        Boolean refusal = solid.portalable() ? Boolean.FALSE : null;
        return changed(
                solid,
                rest,
                said -> new Solid.Face(said.material(), refusal),
                whole -> RecordMembers.with(whole, "portalable", false));
    }

    static Solid withMaterial(Solid solid, String rest, String material) {
        return changed(
                solid,
                rest,
                said -> new Solid.Face(material, said.portalable()),
                whole -> RecordMembers.with(whole, "material", material));
    }

    private static Solid changed(
            Solid solid, String rest, UnaryOperator<Solid.Face> ofFace, UnaryOperator<Record> ofSolid) {
        String name = face(rest).orElse("");
        if (solid instanceof Solid.Box box) {
            for (BoxFace side : BoxFace.values()) {
                if (side.text().equals(name)) {
                    return (Solid) RecordMembers.with(box, "faces", changed(box.faces(), side, ofFace));
                }
            }
        } else if (solid instanceof Solid.Wedge wedge && !name.isEmpty()) {
            return (Solid) RecordMembers.with(wedge, "faces", changed(wedge.faces(), name, ofFace));
        } else if (solid instanceof Solid.Planes planes && !name.isEmpty()) {
            int index = Integer.parseInt(name.substring("planes[".length(), name.length() - 1));
            return (Solid) RecordMembers.with(planes, "planes", changed(planes.planes(), index, ofFace));
        }
        return (Solid) ofSolid.apply((Record) solid);
    }

    private static <K> Map<K, Solid.Face> changed(Map<K, Solid.Face> faces, K key, UnaryOperator<Solid.Face> ofFace) {
        Map<K, Solid.Face> changed = new LinkedHashMap<>(faces);
        Solid.Face nothing = new Solid.Face(null, null);
        Solid.Face said = ofFace.apply(faces.getOrDefault(key, nothing));
        if (said.equals(nothing)) {
            changed.remove(key);
        } else {
            changed.put(key, said);
        }
        return changed;
    }

    private static List<Solid.PlaneFace> changed(
            List<Solid.PlaneFace> planes, int index, UnaryOperator<Solid.Face> ofFace) {
        List<Solid.PlaneFace> changed = new ArrayList<>(planes);
        Solid.PlaneFace plane = planes.get(index);
        Solid.Face said = ofFace.apply(new Solid.Face(plane.material(), plane.portalable()));
        changed.set(
                index, new Solid.PlaneFace(plane.normal(), plane.distanceMetres(), said.material(), said.portalable()));
        return List.copyOf(changed);
    }
}
