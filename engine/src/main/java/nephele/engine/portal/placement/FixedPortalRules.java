package nephele.engine.portal.placement;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import nephele.engine.level.Brush;
import nephele.engine.level.Level;
import nephele.engine.level.PortalSpec;
import nephele.engine.level.Problem;
import nephele.engine.level.Solid;
import nephele.engine.level.appearance.MirrorFaces;
import nephele.engine.level.appearance.SolidFaces;
import nephele.engine.level.placed.LevelRule;
import nephele.engine.level.placed.PlacedModel;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portal;

/**
 * The rule for fixed portals that a player would see otherwise than intended: warnings, and an error for a portal on a
 * mirror. An instance holds the surfaces under one portal, and the obstacles directly in front of it.
 */
public final class FixedPortalRules {
    /** Greatest overlap that counts as rounding. */
    private static final double LEAST_METRES = 1e-3;

    /** Least width of a hidden strip that is reported; a narrower one along an edge is a doorstep or a frame. */
    private static final double LEAST_HIDDEN_METRES = 0.05;

    /** Least width of a piece; thinner ones are rounding, or cracks between the triangles of a mesh. */
    private static final double THINNEST_METRES = Tolerance.CRACK;

    public static final LevelRule AS_INTENDED =
            new LevelRule(LevelRule.Stage.WORLD, (level, assets, statics, report) -> {
                List<Portal> portals = level.portals().stream().map(Portal::of).toList();
                for (int i = 0; i < portals.size(); i++) {
                    String path = "portals[" + i + "].centre";
                    for (int j = 0; j < i; j++) {
                        if (overlap(portals.get(i), portals.get(j))) {
                            report.accept(Problem.warning(
                                    path, onTop(j, level.portals().get(j))));
                        }
                    }
                    FixedPortalRules wall = new FixedPortalRules(portals.get(i), level, statics);
                    double uncovered = wall.uncoveredMetres();
                    if (uncovered > LEAST_METRES) {
                        report.accept(Problem.warning(path, overEdge(uncovered)));
                    }
                    if (wall.withoutLeave != null) {
                        report.accept(Problem.warning(path, withoutLeave(wall.withoutLeave)));
                    }
                    if (wall.mirror != null) {
                        report.accept(Problem.error(path, onMirror(wall.mirror)));
                    }
                    if (wall.hiddenBy != null) {
                        report.accept(Problem.warning(path, wall.isCentreHidden ? closed(wall) : hidden(wall)));
                    }
                }
            });

    private final PlaneFrame frame;
    private final ConvexPolygon outline;
    private final Aabb bounds;
    /** Convex pieces of the outline that no face covers. */
    private List<ConvexPolygon> uncovered;

    private boolean isCentreCovered;
    private boolean isCentreHidden;
    private final Set<String> mirrors;
    private String withoutLeave;
    private String mirror;
    private String hiddenBy;

    private FixedPortalRules(Portal portal, Level level, StaticShapes statics) {
        frame = new PlaneFrame(portal.centre(), portal.frame());
        outline = outline(frame, portal);
        uncovered = List.of(outline);
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

    private void addSolid(Brush brush, String path, Solid authored) {
        for (Brush.BrushFace face : brush.faces()) {
            boolean holds = addFace(face.polygon(), face.plane().normal());
            String name = path + (authored instanceof Solid.Planes ? "." : ".faces.") + face.name();
            if (holds && mirrors.contains(face.material())) {
                mirror = name;
            } else if (holds && saysNo(authored, face.name())) {
                withoutLeave = name;
            }
        }
        addBefore(path, brush.solidId(), new Blocker.Convex(brush, 0).loops());
    }

    private void addModel(PlacedModel model, String path) {
        String id = model.authored().id();
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
        cover(face);
        return ConvexPolygon.gap(outline, face) < -LEAST_METRES;
    }

    private void addBefore(String path, String id, List<List<Vec3>> loops) {
        ConvexPolygon footprint = ConvexPolygon.footprint(frame, loops, Tolerance.COPLANAR, Tolerance.STANDS_AGAINST);
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
    private static boolean saysNo(Solid authored, String face) {
        return Boolean.FALSE.equals(SolidFaces.authored(authored, face).portalable());
    }

    /** Removes what a face covers from the uncovered pieces. */
    private void cover(ConvexPolygon cover) {
        List<ConvexPolygon> left = new ArrayList<>();
        for (ConvexPolygon piece : uncovered) {
            if (ConvexPolygon.gap(piece, cover) >= 0) {
                left.add(piece);
            } else {
                addOutside(piece, cover, left);
            }
        }
        uncovered = left;
    }

    private static void addOutside(ConvexPolygon piece, ConvexPolygon cover, List<ConvexPolygon> left) {
        ConvexPolygon rest = piece;
        for (int edge = 0; edge < cover.corners() && rest != null; edge++) {
            ConvexPolygon outside = cut(rest, cover, edge, 1);
            if (outside != null) {
                left.add(outside);
            }
            rest = cut(rest, cover, edge, -1);
        }
    }

    /**
     * Returns an estimate of the width of the widest part of the portal without a surface; 0 for one in free space, which
     * another rule reports.
     */
    private double uncoveredMetres() {
        return isCentreCovered
                ? uncovered.stream().mapToDouble(FixedPortalRules::width).max().orElse(0)
                : 0;
    }

    /** Clips by the line along an edge (Sutherland and Hodgman 1974); {@code null} if the rest is too thin. */
    private static ConvexPolygon cut(ConvexPolygon polygon, ConvexPolygon cover, int edge, int side) {
        double[] kept = new double[4 * polygon.corners()];
        int size = 0;
        for (int i = 0; i < polygon.corners(); i++) {
            int next = (i + 1) % polygon.corners();
            double here = side * ahead(cover, edge, polygon.x(i), polygon.y(i));
            double there = side * ahead(cover, edge, polygon.x(next), polygon.y(next));
            if (here >= 0) {
                kept[size++] = polygon.x(i);
                kept[size++] = polygon.y(i);
            }
            if (here < 0 != there < 0) {
                double fraction = here / (here - there);
                kept[size++] = polygon.x(i) + fraction * (polygon.x(next) - polygon.x(i));
                kept[size++] = polygon.y(i) + fraction * (polygon.y(next) - polygon.y(i));
            }
        }
        ConvexPolygon clipped = ConvexPolygon.of(Arrays.copyOf(kept, size));
        return clipped.corners() > 2 && width(clipped) > THINNEST_METRES ? clipped : null;
    }

    private static double ahead(ConvexPolygon cover, int edge, double x, double y) {
        return cover.normalX(edge) * x + cover.normalY(edge) * y - cover.distance(edge);
    }

    /** Returns the width of a rectangle; for other shapes at most half too little. */
    private static double width(ConvexPolygon polygon) {
        double doubledArea = 0;
        double longest = 0;
        for (int i = 0; i < polygon.corners(); i++) {
            int next = (i + 1) % polygon.corners();
            doubledArea += (polygon.x(i) - polygon.x(0)) * (polygon.y(next) - polygon.y(0))
                    - (polygon.x(next) - polygon.x(0)) * (polygon.y(i) - polygon.y(0));
            longest = Math.max(longest, polygon.length(i));
        }
        return longest > 0 ? doubledArea / 2 / longest : 0;
    }

    private static boolean overlap(Portal a, Portal b) {
        PlaneFrame frame = new PlaneFrame(a.centre(), a.frame());
        return a.normal().dot(b.normal()) >= Tolerance.COPLANAR_COSINE
                && Math.abs(frame.height(b.centre())) <= Tolerance.COPLANAR
                && ConvexPolygon.gap(outline(frame, a), outline(frame, b)) < -LEAST_METRES;
    }

    /** Returns a portal's aperture in a plane's coordinates. */
    private static ConvexPolygon outline(PlaneFrame frame, Portal portal) {
        double[] corners = new double[2 * portal.aperture().corners()];
        for (int i = 0; i < portal.aperture().corners(); i++) {
            var corner =
                    portal.world(portal.aperture().cornerX(i), portal.aperture().cornerY(i), 0);
            corners[2 * i] = frame.x(corner);
            corners[2 * i + 1] = frame.y(corner);
        }
        return ConvexPolygon.of(corners);
    }

    private static String onTop(int other, PortalSpec portal) {
        return "overlaps portals[" + other + "] ('" + portal.id() + "') in the same plane: where both are, the player"
                + " sees the picture of one of them and both rims: move one of them";
    }

    private static String overEdge(double metres) {
        return "reaches " + Math.round(metres * 1000) + " mm or more over the edge of its surface: the player sees an"
                + " opening in the air there: move it inwards or make it smaller";
    }

    private static String withoutLeave(String face) {
        return "lies on " + face + ", which says that it takes no portals: the player sees it open all the same: move"
                + " it, or leave portalable out there";
    }

    private static String onMirror(String face) {
        return "lies on " + face + ", a mirror, which takes no portals: move it, or give the face another material";
    }

    private static String closed(FixedPortalRules wall) {
        return wall.hiddenBy + " stands before it: the player sees that instead of the portal, and nothing passes it"
                + " or its partner: move the portal onto the surface in sight";
    }

    private static String hidden(FixedPortalRules wall) {
        return wall.hiddenBy + " stands before a part of it: the player sees that instead of the portal there: move"
                + " one of them";
    }
}
