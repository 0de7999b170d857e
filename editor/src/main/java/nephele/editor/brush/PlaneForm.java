package nephele.editor.brush;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import nephele.engine.level.Brush;
import nephele.engine.level.Brush.BrushFace;
import nephele.engine.level.Solid;
import nephele.engine.level.Solid.PlaneFace;
import nephele.engine.level.appearance.SolidFaces;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;

/** Converts solids to planes, the form in which they are edited, and back to the simplest record. */
final class PlaneForm {
    /** Normals that differ less are those of parallel planes: the engine intersects no planes so nearly parallel. */
    private static final double PARALLEL = 1e-9;

    private static final double SAME_DISTANCE_METRES = 1e-9;

    private PlaneForm() {}

    /** Returns the solid's faces as planes, in the order of its faces; planes without a face are left out. */
    static Solid.Planes of(Solid solid) {
        Brush brush = Brush.of(solid);
        List<PlaneFace> faces = new ArrayList<>(brush.faces().size());
        for (int i = 0; i < brush.faces().size(); i++) {
            if (solid instanceof Solid.Planes planes) {
                int at = brush.shape().faces().get(i).planeIndex();
                faces.add(planes.planes().get(at));
            } else {
                BrushFace face = brush.faces().get(i);
                faces.add(withFace(canonical(face.plane()), SolidFaces.authored(solid, face.name())));
            }
        }
        return with(solid, solid.id(), faces);
    }

    /** Returns a solid of other planes with the properties of this one. */
    static Solid.Planes with(Solid solid, String id, List<PlaneFace> faces) {
        return new Solid.Planes(id, solid.material(), solid.portalable(), solid.textureMapping(), List.copyOf(faces));
    }

    /** Returns what a face shows, no material or portalability inherited. */
    static Solid.Face lookOf(BrushFace face) {
        return new Solid.Face(face.material(), face.portalable(), face.texture());
    }

    /** Returns a plane with a face of this look, of which only what differs from the solid's defaults is written. */
    static PlaneFace look(Solid solid, PlaneFace plane, Solid.Face look) {
        return withFace(plane, authored(solid, look));
    }

    /** Returns the authored part of a face's look: what differs from the solid's defaults. */
    static Solid.Face authored(Solid solid, Solid.Face look) {
        boolean isPortalable = look.portalable() == null || look.portalable() == solid.portalable();
        return new Solid.Face(
                Objects.equals(look.material(), solid.material()) ? null : look.material(),
                isPortalable ? null : look.portalable(),
                look.texture());
    }

    private static PlaneFace withFace(PlaneFace plane, Solid.Face face) {
        return new PlaneFace(
                plane.normal(), plane.distanceMetres(), face.material(), face.portalable(), face.texture());
    }

    /** Returns another plane with the same face. */
    static PlaneFace at(PlaneFace face, Vec3 normal, double distanceMetres) {
        return new PlaneFace(normal, distanceMetres, face.material(), face.portalable(), face.texture());
    }

    /** Returns a plane as written by this package: no negative zeros, and oblique distances snapped. */
    static PlaneFace canonical(Plane plane) {
        Vec3 normal = ExactNumber.positiveZeros(plane.normal());
        double distance = isAlongAxis(normal) ? plane.distance() + 0.0 : ExactNumber.snapped(plane.distance());
        return new PlaneFace(normal, distance, null, null, null);
    }

    static PlaneFace opposite(PlaneFace face) {
        return at(face, ExactNumber.positiveZeros(face.normal().negated()), -face.distanceMetres() + 0.0);
    }

    static Plane plane(PlaneFace face) {
        return Plane.of(face.normal(), face.distanceMetres());
    }

    static boolean isAlongAxis(Vec3 normal) {
        int zeros = (normal.x() == 0 ? 1 : 0) + (normal.y() == 0 ? 1 : 0) + (normal.z() == 0 ? 1 : 0);
        return zeros == 2;
    }

    /**
     * Returns the simplest valid solid that the planes enclose, without planes that have no face. Refused as no solid
     * if there is none, and if the engine cannot separate its corners so far from the origin.
     */
    static BrushEdit<Solid> rebuilt(Solid.Planes solid) {
        List<PlaneFace> distinct = distinct(solid.planes());
        if (distinct.size() > ConvexPolyhedron.MAX_PLANES) {
            return BrushEdit.refused(BrushText.TOO_MANY_FACES);
        }
        List<PlaneFace> kept = new ArrayList<>();
        try {
            List<Plane> planes = distinct.stream().map(PlaneForm::plane).toList();
            ConvexPolyhedron.fromPlanes(planes).faces().forEach(face -> kept.add(distinct.get(face.planeIndex())));
        } catch (IllegalArgumentException nothing) {
            return BrushEdit.refused(BrushText.NOT_SOLID);
        }
        return BrushCheck.checked(SimplestSolid.of(with(solid, solid.id(), kept)));
    }

    /** Returns of parallel planes only the one farthest in. */
    private static List<PlaneFace> distinct(List<PlaneFace> faces) {
        List<PlaneFace> distinct = new ArrayList<>();
        for (PlaneFace face : faces) {
            int same = parallel(distinct, plane(face));
            if (same < 0) {
                distinct.add(face);
            } else if (face.distanceMetres() < distinct.get(same).distanceMetres() - SAME_DISTANCE_METRES) {
                distinct.set(same, face);
            }
        }
        return distinct;
    }

    private static int parallel(List<PlaneFace> faces, Plane plane) {
        for (int i = 0; i < faces.size(); i++) {
            if (plane(faces.get(i)).normal().minus(plane.normal()).length() <= PARALLEL) {
                return i;
            }
        }
        return -1;
    }
}
