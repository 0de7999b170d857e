package nephele.engine.portal.placement;

import java.util.List;
import java.util.Set;
import nephele.engine.level.Brush;
import nephele.engine.level.Level;
import nephele.engine.level.Solid;
import nephele.engine.level.appearance.MirrorFaces;
import nephele.engine.level.appearance.SolidFaces;
import nephele.engine.level.placed.PlacedModel;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portal;

/** The surfaces under a fixed portal, and the obstacles directly in front of it. */
final class PortalWall {
    /** Greatest overlap that counts as rounding. */
    private static final double LEAST_METRES = 1e-3;

    /** Least width of a hidden strip that is reported; a narrower one along an edge is a doorstep or a frame. */
    private static final double LEAST_HIDDEN_METRES = 0.05;

    private final PlaneFrame frame;
    private final ConvexPolygon outline;
    private final Aabb bounds;
    private final PolygonDifference uncovered;
    private boolean isCentreCovered;
    private boolean isCentreHidden;
    private final Set<String> mirrors;
    private String withoutLeave;
    private String mirror;
    private String hiddenBy;

    PortalWall(Portal portal, Level level, StaticShapes statics) {
        frame = new PlaneFrame(portal.centre(), portal.frame());
        outline = FixedPortalRules.outline(frame, portal);
        uncovered = new PolygonDifference(outline);
        mirrors = MirrorFaces.materials(level.materials());
        Aabb flat = Aabb.EMPTY;
        for (int i = 0; i < portal.aperture().corners(); i++) {
            Vec3 corner =
                    portal.world(portal.aperture().cornerX(i), portal.aperture().cornerY(i), 0);
            flat = flat.union(Aabb.of(List.of(corner)));
        }
        bounds = flat.grown(Tolerance.STANDS_AGAINST);
        for (int i = 0; i < statics.solids().size(); i++) {
            if (statics.solids().get(i).shape().bounds().overlaps(bounds)) {
                addSolid(
                        statics.solids().get(i),
                        "solids[" + i + "]",
                        level.solids().get(i));
            }
        }
        for (PlacedModel model : statics.models().all()) {
            if (model.bounds().overlaps(bounds)) {
                addModel(model, "models[" + model.index() + "]");
            }
        }
    }

    private void addSolid(Brush brush, String path, Solid said) {
        for (Brush.BrushFace face : brush.faces()) {
            boolean holds = addFace(face.polygon(), face.plane().normal());
            String name = path + (said instanceof Solid.Planes ? "." : ".faces.") + face.name();
            if (holds && mirrors.contains(face.material())) {
                mirror = name;
            } else if (holds && saysNo(said, face.name())) {
                withoutLeave = name;
            }
        }
        addBefore(path, brush.solidId(), new Blocker.Convex(brush, 0).loops());
    }

    private void addModel(PlacedModel model, String path) {
        String id = model.said().id();
        if (model.solid() != null) {
            addBefore(path, id, new Blocker.Convex(model.solid(), 0).loops());
        }
        for (int i = 0; i < model.triangles().count(); i++) {
            List<Vec3> corners = List.of(
                    model.triangles().corner(i, 0),
                    model.triangles().corner(i, 1),
                    model.triangles().corner(i, 2));
            if (Aabb.of(corners).overlaps(bounds)) {
                addFace(corners, model.triangles().faceNormal(i));
                if (model.solid() == null) {
                    addBefore(path, id, List.of(corners));
                }
            }
        }
    }

    /** Adds a face; returns true if it carries a part of the portal. */
    private boolean addFace(List<Vec3> corners, Vec3 normal) {
        Vec3 p = corners.get(0);
        double off = normal.x() * (frame.origin().x() - p.x())
                + normal.y() * (frame.origin().y() - p.y())
                + normal.z() * (frame.origin().z() - p.z());
        boolean isInPlane =
                Math.abs(off) <= Tolerance.COPLANAR && normal.dot(frame.normal()) >= Tolerance.COPLANAR_COSINE;
        if (!isInPlane) {
            return false;
        }
        ConvexPolygon face = ConvexPolygon.of(frame, corners);
        isCentreCovered |= face.outside(0, 0) <= Tolerance.CRACK;
        uncovered.cover(face);
        return ConvexPolygon.gap(outline, face) < -LEAST_METRES;
    }

    private void addBefore(String path, String id, List<List<Vec3>> loops) {
        ConvexPolygon footprint = Footprints.of(frame, loops, Tolerance.COPLANAR, Tolerance.STANDS_AGAINST);
        if (footprint == null || ConvexPolygon.gap(outline, footprint) >= -LEAST_HIDDEN_METRES) {
            return;
        }
        boolean holdsCentre = footprint.outside(0, 0) < 0;
        if (hiddenBy == null || holdsCentre && !isCentreHidden) {
            hiddenBy = path + " ('" + id + "')";
        }
        isCentreHidden |= holdsCentre;
    }

    /** Returns true if the author marked this very face as not portalable. */
    private static boolean saysNo(Solid said, String face) {
        return Boolean.FALSE.equals(SolidFaces.said(said, face).portalable());
    }

    /**
     * Returns the width of the part of the portal without a surface; 0 for one in free space, which another rule
     * reports.
     */
    double uncoveredMetres() {
        return isCentreCovered ? uncovered.widthMetres() : 0;
    }

    /** Returns a face under the portal that is marked as not portalable, or {@code null}. */
    String withoutLeave() {
        return withoutLeave;
    }

    /** Returns a face under the portal that is a mirror, or {@code null}. */
    String mirror() {
        return mirror;
    }

    /** Returns the obstacle within a centimetre in front of the portal, or {@code null}. */
    String hiddenBy() {
        return hiddenBy;
    }

    /** Returns true if an obstacle hides the centre, so that the simulation keeps the pair closed. */
    boolean isCentreHidden() {
        return isCentreHidden;
    }
}
