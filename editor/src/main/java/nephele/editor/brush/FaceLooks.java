package nephele.editor.brush;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import nephele.engine.level.Brush;
import nephele.engine.level.Brush.BrushFace;
import nephele.engine.level.Solid;
import nephele.engine.level.appearance.SolidFaces;

/**
 * Changes of what the faces of a solid show, where {@link SolidFaces} changes what they say: what equals the solid's
 * default is not written. Faces are counted in the order of {@code Brush.of(solid).faces()}.
 */
public final class FaceLooks {
    private FaceLooks() {}

    /**
     * Returns what each face shows: a material of {@code null} is grey, a placement of {@code null} leaves the picture
     * as the solid's mapping says.
     */
    public static List<Solid.Face> of(Solid solid) {
        return Brush.of(solid).faces().stream().map(PlaneForm::lookOf).toList();
    }

    /** Returns the solid with another material on a face; {@code null} is grey. */
    public static Solid withMaterial(Solid solid, int face, String material) {
        Solid.Face look = of(solid).get(face);
        return with(solid, face, new Solid.Face(material, look.portalable(), look.texture()));
    }

    /** Returns the solid with a face that takes portals or does not. */
    public static Solid withPortalable(Solid solid, int face, boolean portalable) {
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
    public static Solid withMaterial(Solid solid, String material) {
        List<Solid.Face> looks = of(solid).stream()
                .map(look -> new Solid.Face(material, look.portalable(), look.texture()))
                .toList();
        return withDefault(solid, material, looks);
    }

    /** Returns the solid with all faces portalable or none. */
    public static Solid withPortalable(Solid solid, boolean portalable) {
        List<Solid.Face> looks = of(solid).stream()
                .map(look -> new Solid.Face(look.material(), portalable, look.texture()))
                .toList();
        BrushStyle style = new BrushStyle(solid.material(), portalable, solid.textureMapping());
        return written(Identity.with(solid, solid.id(), style), looks);
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
        return written(Identity.with(solid, solid.id(), style), looks);
    }

    /** Leaves planes without a face as they are. */
    private static Solid written(Solid solid, List<Solid.Face> looks) {
        List<BrushFace> faces = Brush.of(solid).faces();
        Solid written = solid;
        for (int i = 0; i < faces.size(); i++) {
            written = SolidFaces.with(written, faces.get(i).name(), said(solid, looks.get(i)));
        }
        return written;
    }

    /** Returns what a face with this look says beside the defaults; a portalability of {@code null} is the default. */
    static Solid.Face said(Solid solid, Solid.Face look) {
        boolean isPortalable = look.portalable() == null || look.portalable() == solid.portalable();
        return new Solid.Face(
                Objects.equals(look.material(), solid.material()) ? null : look.material(),
                isPortalable ? null : look.portalable(),
                look.texture());
    }
}
