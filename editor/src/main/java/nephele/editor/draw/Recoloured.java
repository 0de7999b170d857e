package nephele.editor.draw;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import nephele.engine.level.Material;
import nephele.engine.level.ModelPlacement;
import nephele.engine.level.Solid;
import nephele.engine.math.Vec3;

/** Copies of records with other materials. */
final class Recoloured {
    private Recoloured() {}

    /** Returns a plain material. */
    static Material material(String id, Vec3 colour) {
        return new Material(id, colour, null, null, null, null, Vec3.ZERO, 1);
    }

    /** Returns a solid with one material on all its faces. */
    static Solid solid(Solid solid, String material) {
        return new Faces(solid, (said, isPortalable) -> material).copy();
    }

    /**
     * Returns a solid whose faces have one of two materials.
     *
     * @param isMirror tells which materials refuse portals
     */
    static Solid byPortals(Solid solid, Predicate<String> isMirror, String portalable, String others) {
        return new Faces(
                        solid,
                        (said, isPortalable) ->
                                isPortalable && !(said != null && isMirror.test(said)) ? portalable : others)
                .copy();
    }

    static ModelPlacement model(ModelPlacement said, String material) {
        return said.withMaterial(material);
    }

    /** Chooses a face's material from its own one, {@code null} for grey, and from whether it takes portals. */
    @FunctionalInterface
    private interface Choice {
        String material(String said, boolean isPortalable);
    }

    /** A solid whose faces get other materials, which are plain, so that no placement of pictures counts. */
    private record Faces(Solid solid, Choice choice) {
        Solid copy() {
            Solid whole = solid.with(solid.id(), chosen(null, null), solid.portalable(), solid.textureMapping());
            if (whole instanceof Solid.Box box) {
                return box.withFaces(faces(box.faces()));
            } else if (whole instanceof Solid.Wedge wedge) {
                return wedge.withFaces(faces(wedge.faces()));
            } else if (whole instanceof Solid.Prism prism) {
                return prism.withFaces(faces(prism.faces()));
            }
            Solid.Planes planes = (Solid.Planes) whole;
            return planes.withPlanes(planes.planes().stream().map(this::face).collect(Collectors.toList()));
        }

        private Solid.PlaneFace face(Solid.PlaneFace said) {
            return new Solid.PlaneFace(
                    said.normal(),
                    said.distanceMetres(),
                    chosen(said.material(), said.portalable()),
                    said.portalable(),
                    null);
        }

        private <K> Map<K, Solid.Face> faces(Map<K, Solid.Face> said) {
            Map<K, Solid.Face> others = new LinkedHashMap<>();
            said.forEach((side, face) -> others.put(
                    side, new Solid.Face(chosen(face.material(), face.portalable()), face.portalable(), null)));
            return others;
        }

        private String chosen(String material, Boolean isPortalable) {
            return choice.material(
                    material == null ? solid.material() : material,
                    isPortalable == null ? solid.portalable() : isPortalable);
        }
    }
}
