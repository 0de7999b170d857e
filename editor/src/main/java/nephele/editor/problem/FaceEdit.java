package nephele.editor.problem;

import java.util.Optional;
import java.util.function.UnaryOperator;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import nephele.editor.document.LevelShapes;
import nephele.editor.record.RecordKind;
import nephele.engine.level.Brush.BrushFace;
import nephele.engine.level.Level;
import nephele.engine.level.Solid;
import nephele.engine.level.appearance.SolidFaces;

/** Changes of a face's material and portalability, by the path of its record; without one, of the whole solid. */
final class FaceEdit {
    private static final Pattern NAMED = Pattern.compile("\\.faces\\.([^.]+).*");
    private static final Pattern PLANE = Pattern.compile("\\.(planes\\[(\\d{1,9})\\]).*");

    private FaceEdit() {}

    /** Returns the name of the face that a path leads to; empty for the solid itself. */
    static Optional<String> face(String rest) {
        Matcher named = NAMED.matcher(rest);
        Matcher plane = PLANE.matcher(rest);
        return named.matches()
                ? Optional.of(named.group(1))
                : plane.matches() ? Optional.of(plane.group(1)) : Optional.empty();
    }

    /** Returns the derived face that a path leads to; empty for none. */
    static Optional<BrushFace> derived(Level level, EntityPath place) {
        if (!(place.entity(level) instanceof Solid solid)) {
            return Optional.empty();
        }
        String name = face(place.rest()).orElse(null);
        return LevelShapes.brushOf(solid).stream()
                .flatMap(brush -> brush.faces().stream())
                .filter(face -> face.name().equals(name))
                .findFirst();
    }

    /** Returns the solid with a face, or all that say nothing, not portalable. */
    static Solid withoutPortals(Solid solid, String rest) {
        Boolean refusal = solid.portalable() ? Boolean.FALSE : null;
        return changed(
                solid,
                rest,
                authored -> new Solid.Face(authored.material(), refusal, authored.texture()),
                whole -> RecordKind.with(whole, "portalable", false));
    }

    static Solid withMaterial(Solid solid, String rest, String material) {
        return changed(
                solid,
                rest,
                authored -> new Solid.Face(material, authored.portalable(), authored.texture()),
                whole -> RecordKind.with(whole, "material", material));
    }

    /** A solid of which the path names a face that it has not stays as it is. */
    private static Solid changed(
            Solid solid, String rest, UnaryOperator<Solid.Face> ofFace, UnaryOperator<Record> ofSolid) {
        String name = face(rest).orElse("");
        if (name.isEmpty()) {
            return (Solid) ofSolid.apply((Record) solid);
        }
        return SolidFaces.names(solid).contains(name)
                ? SolidFaces.with(solid, name, ofFace.apply(SolidFaces.said(solid, name)))
                : solid;
    }
}
