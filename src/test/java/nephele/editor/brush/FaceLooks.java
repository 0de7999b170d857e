package nephele.editor.brush;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.Brush;
import nephele.engine.level.Brush.BrushFace;
import nephele.engine.level.Solid;
import nephele.engine.level.appearance.SolidFaces;

/** Changes the visible material and portalability of faces, in the order of {@code Brush.of(solid).faces()}. */
final class FaceLooks {
    private FaceLooks() {}

    /**
     * Returns what each face shows: a material of {@code null} is grey, a placement of {@code null} leaves the picture
     * as the solid's mapping says.
     */
    static List<Solid.Face> of(Solid solid) {
        return Brush.of(solid).faces().stream().map(PlaneForm::lookOf).toList();
    }

    /** Returns the solid with another material on a face; {@code null} is grey. */
    static Solid withMaterial(Solid solid, int face, String material) {
        Solid.Face look = of(solid).get(face);
        return with(solid, face, new Solid.Face(material, look.portalable(), look.texture()));
    }

    /** Returns the solid with a face that takes portals or does not. */
    static Solid withPortalable(Solid solid, int face, boolean portalable) {
        Solid.Face look = of(solid).get(face);
        return with(solid, face, new Solid.Face(look.material(), portalable, look.texture()));
    }

    private static Solid with(Solid solid, int face, Solid.Face look) {
        List<Solid.Face> looks = new ArrayList<>(of(solid));
        if (looks.get(face).equals(look)) {
            return solid;
        }
        looks.set(face, look);
        return with(solid, looks);
    }

    /** Returns the solid with this default material on all faces; {@code null} is grey. */
    static Solid withMaterial(Solid solid, String material) {
        List<Solid.Face> looks = of(solid).stream()
                .map(look -> new Solid.Face(material, look.portalable(), look.texture()))
                .toList();
        return withDefault(solid, material, looks);
    }

    /** Returns the solid with all faces portalable or none. */
    static Solid withPortalable(Solid solid, boolean portalable) {
        List<Solid.Face> looks = of(solid).stream()
                .map(look -> new Solid.Face(look.material(), portalable, look.texture()))
                .toList();
        BrushStyle style = new BrushStyle(solid.material(), portalable, solid.textureMapping());
        return written(solid.with(solid.id(), style.material(), style.portalable(), style.textureMapping()), looks);
    }

    /**
     * Returns the solid with these faces, nothing in them inherited. Inside a solid whose default is not grey no face
     * can say grey, so that grey becomes the default where a face needs it.
     */
    private static Solid with(Solid solid, List<Solid.Face> looks) {
        boolean needsGrey = looks.stream().anyMatch(look -> look.material() == null);
        return withDefault(solid, needsGrey ? null : solid.material(), looks);
    }

    private static Solid withDefault(Solid solid, String material, List<Solid.Face> looks) {
        BrushStyle style = new BrushStyle(material, solid.portalable(), solid.textureMapping());
        return written(solid.with(solid.id(), style.material(), style.portalable(), style.textureMapping()), looks);
    }

    /** Leaves planes without a face as they are. */
    private static Solid written(Solid solid, List<Solid.Face> looks) {
        List<BrushFace> faces = Brush.of(solid).faces();
        Solid written = solid;
        for (int i = 0; i < faces.size(); i++) {
            written = SolidFaces.with(written, faces.get(i).name(), PlaneForm.authored(solid, looks.get(i)));
        }
        return written;
    }
}
