package nephele.editor.brush;

import java.util.ArrayList;
import java.util.Collections;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import nephele.engine.level.BoxFace;
import nephele.engine.level.Brush;
import nephele.engine.level.Solid;
import nephele.engine.level.Solid.PlaneFace;
import nephele.engine.math.ConvexPolyhedron;

/**
 * Reading and writing of the material and portalability of single faces. Faces are counted in the order of {@code
 * Brush.of(solid).faces()}; what equals the solid's default is not written.
 */
public final class SolidFaces {
    private SolidFaces() {}

    /** Returns what each face shows, nothing inherited: only a material may be {@code null}, for grey. */
    public static List<Solid.Face> of(Solid solid) {
        return Brush.of(solid).faces().stream().map(PlaneForm::lookOf).toList();
    }

    /** Returns the solid with another material on a face; {@code null} is grey. */
    public static Solid withMaterial(Solid solid, int face, String material) {
        return with(solid, face, new Solid.Face(material, of(solid).get(face).portalable()));
    }

    /** Returns the solid with a face that takes portals or does not. */
    public static Solid withPortalable(Solid solid, int face, boolean portalable) {
        return with(solid, face, new Solid.Face(of(solid).get(face).material(), portalable));
    }

    private static Solid with(Solid solid, int face, Solid.Face look) {
        List<Solid.Face> looks = new ArrayList<>(of(solid));
        if (looks.get(face).equals(look)) {
            return solid;
        }
        looks.set(face, look);
        return with(solid, looks);
    }

    /** Returns the solid with this default material and no face that differs; {@code null} is grey. */
    public static Solid withMaterial(Solid solid, String material) {
        List<Solid.Face> looks = of(solid).stream()
                .map(look -> new Solid.Face(material, look.portalable()))
                .toList();
        return withDefault(solid, material, looks);
    }

    /** Returns the solid with all faces portalable or none. */
    public static Solid withPortalable(Solid solid, boolean portalable) {
        List<Solid.Face> looks = of(solid).stream()
                .map(look -> new Solid.Face(look.material(), portalable))
                .toList();
        BrushStyle style = new BrushStyle(solid.material(), portalable, solid.textureMapping());
        return written(Identity.with(solid, solid.id(), style), looks);
    }

    /**
     * Returns the solid with these faces, nothing in them inherited. Inside a solid whose default is not grey no face
     * can say grey, so that grey becomes the default where a face needs it.
     */
    static Solid with(Solid solid, List<Solid.Face> looks) {
        boolean needsGrey = looks.stream().anyMatch(look -> look.material() == null);
        return withDefault(solid, needsGrey ? null : solid.material(), looks);
    }

    private static Solid withDefault(Solid solid, String material, List<Solid.Face> looks) {
        BrushStyle style = new BrushStyle(material, solid.portalable(), solid.textureMapping());
        return written(Identity.with(solid, solid.id(), style), looks);
    }

    private static Solid written(Solid solid, List<Solid.Face> looks) {
        if (solid instanceof Solid.Box box) {
            return box(box, looks);
        } else if (solid instanceof Solid.Wedge wedge) {
            return wedge(wedge, looks);
        } else if (solid instanceof Solid.Planes planes) {
            return planes(planes, looks);
        }
        boolean isUniform = looks.stream().noneMatch(look -> said(solid, look) != null);
        return isUniform ? solid : planes(PlaneForm.of(solid), looks);
    }

    /** Returns what a face says beside the defaults; {@code null} for nothing. */
    private static Solid.Face said(Solid solid, Solid.Face look) {
        String material = Objects.equals(look.material(), solid.material()) ? null : look.material();
        Boolean portalable = look.portalable() == solid.portalable() ? null : look.portalable();
        return material == null && portalable == null ? null : new Solid.Face(material, portalable);
    }

    private static Solid box(Solid.Box b, List<Solid.Face> looks) {
        Map<BoxFace, Solid.Face> faces = new EnumMap<>(BoxFace.class);
        for (BoxFace side : BoxFace.values()) {
            Solid.Face said = said(b, looks.get(side.ordinal()));
            if (said != null) {
                faces.put(side, said);
            }
        }
        return new Solid.Box(
                b.id(),
                b.material(),
                b.portalable(),
                b.textureMapping(),
                b.centre(),
                b.size(),
                Collections.unmodifiableMap(faces));
    }

    private static Solid wedge(Solid.Wedge w, List<Solid.Face> looks) {
        Map<String, Solid.Face> faces = new LinkedHashMap<>();
        List<Brush.BrushFace> all = Brush.of(w).faces();
        for (int i = 0; i < all.size(); i++) {
            Solid.Face said = said(w, looks.get(i));
            if (said != null) {
                faces.put(all.get(i).name(), said);
            }
        }
        return new Solid.Wedge(
                w.id(),
                w.material(),
                w.portalable(),
                w.textureMapping(),
                w.centre(),
                w.size(),
                w.rising(),
                Collections.unmodifiableMap(faces));
    }

    /** Leaves planes without a face as they are. */
    private static Solid planes(Solid.Planes solid, List<Solid.Face> looks) {
        List<PlaneFace> planes = new ArrayList<>(solid.planes());
        List<ConvexPolyhedron.Face> faces = Brush.of(solid).shape().faces();
        for (int i = 0; i < faces.size(); i++) {
            int at = faces.get(i).planeIndex();
            planes.set(at, PlaneForm.look(solid, planes.get(at), looks.get(i)));
        }
        return PlaneForm.with(solid, solid.id(), planes);
    }
}
