package nephele.engine.collision;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.math.Aabb;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Plane;
import nephele.engine.math.PolyhedronCut;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Aperture;
import nephele.engine.portal.Portal;

/**
 * The aperture volume: the hole in this side's solids behind an open portal. It is the aperture's own prism for the
 * first {@link #FRAME_METRES}, then a box so wide and deep that no body with its centre in front of the portal reaches
 * its end. What is left of the wall at the portal's plane is a thin, exact frame, with room behind it for the other
 * side's solids.
 */
final class Cave {
    /** Thickness of the frame that is left of the wall. */
    static final double FRAME_METRES = 5e-4;

    private final Plane front;
    private final Plane frameEnd;
    private final List<Plane> throat;
    private final List<Plane> chamber;
    private final Aabb bounds;

    private Cave(Portal portal, double reachMetres, List<Plane> shared) {
        front = behind(portal, 0);
        frameEnd = behind(portal, FRAME_METRES);
        throat = new ArrayList<>(shared);
        throat.addAll(edges(portal));
        chamber = new ArrayList<>(shared);
        Aperture aperture = portal.aperture();
        double x = aperture.widthMetres() / 2 + reachMetres;
        double y = aperture.heightMetres() / 2 + reachMetres;
        chamber.add(lateral(portal, 1, 0, x));
        chamber.add(lateral(portal, -1, 0, x));
        chamber.add(lateral(portal, 0, 1, y));
        chamber.add(lateral(portal, 0, -1, y));
        Plane back = behind(portal, reachMetres);
        chamber.add(new Plane(-back.nx(), -back.ny(), -back.nz(), -back.distance()));
        bounds = bounds(portal, x, y, reachMetres);
    }

    /**
     * @param reachMetres depth of the volume, and its margin around the aperture
     * @param shared planes that separate it from the volumes of other portals; it is on their negative side
     */
    static Cave behind(Portal portal, double reachMetres, List<Plane> shared) {
        return new Cave(portal, reachMetres, shared);
    }

    /** Returns the plane at a distance behind the portal, with the portal's normal. */
    private static Plane behind(Portal portal, double metres) {
        return through(portal.normal(), portal.world(0, 0, -metres));
    }

    static Plane through(Vec3 normal, Vec3 point) {
        double distance = normal.x() * point.x() + normal.y() * point.y() + normal.z() * point.z();
        return new Plane(normal.x(), normal.y(), normal.z(), distance);
    }

    private static List<Plane> edges(Portal portal) {
        Aperture aperture = portal.aperture();
        List<Plane> edges = new ArrayList<>();
        for (int i = 0; i < aperture.corners(); i++) {
            edges.add(lateral(portal, aperture.edgeNormalX(i), aperture.edgeNormalY(i), aperture.edgeDistance(i)));
        }
        return edges;
    }

    /**
     * Returns a plane perpendicular to the portal's, from its unit normal and distance from the centre in portal
     * coordinates.
     */
    private static Plane lateral(Portal portal, double x, double y, double metres) {
        Vec3 right = portal.frame().right();
        Vec3 up = portal.frame().up();
        Vec3 normal = new Vec3(x * right.x() + y * up.x(), x * right.y() + y * up.y(), x * right.z() + y * up.z());
        return through(normal, portal.world(x * metres, y * metres, 0));
    }

    private static Aabb bounds(Portal portal, double x, double y, double reach) {
        List<Vec3> corners = new ArrayList<>();
        for (int i = 0; i < 8; i++) {
            corners.add(portal.world((i & 1) == 0 ? x : -x, (i & 2) == 0 ? y : -y, (i & 4) == 0 ? 0 : -reach));
        }
        return Aabb.of(corners);
    }

    Aabb bounds() {
        return bounds;
    }

    /** Adds the parts of a solid outside the volume, as convex pieces. */
    void carve(ConvexPolyhedron solid, List<ConvexPolyhedron> left) {
        PolyhedronCut atFront = PolyhedronCut.of(solid, front);
        add(atFront.inFront(), left);
        if (atFront.behind() != null) {
            PolyhedronCut atFrame = PolyhedronCut.of(atFront.behind(), frameEnd);
            takeOut(atFrame.inFront(), throat, left);
            takeOut(atFrame.behind(), chamber, left);
        }
    }

    /** Adds the parts of a solid inside the volume, as convex pieces. */
    void fill(ConvexPolyhedron solid, List<ConvexPolyhedron> inside) {
        ConvexPolyhedron rest = PolyhedronCut.of(solid, front).behind();
        if (rest != null) {
            PolyhedronCut atFrame = PolyhedronCut.of(rest, frameEnd);
            add(common(atFrame.inFront(), throat), inside);
            add(common(atFrame.behind(), chamber), inside);
        }
    }

    private static void add(ConvexPolyhedron piece, List<ConvexPolyhedron> to) {
        if (piece != null) {
            to.add(piece);
        }
    }

    /** Adds the parts of a solid that are outside at least one of the planes. */
    private static void takeOut(ConvexPolyhedron solid, List<Plane> planes, List<ConvexPolyhedron> left) {
        if (common(solid, planes) == null) {
            add(solid, left);
            return;
        }
        ConvexPolyhedron rest = solid;
        for (Plane plane : planes) {
            PolyhedronCut cut = PolyhedronCut.of(rest, plane);
            add(cut.inFront(), left);
            rest = cut.behind();
        }
    }

    private static ConvexPolyhedron common(ConvexPolyhedron solid, List<Plane> planes) {
        ConvexPolyhedron rest = solid;
        for (int i = 0; i < planes.size() && rest != null; i++) {
            rest = PolyhedronCut.of(rest, planes.get(i)).behind();
        }
        return rest;
    }
}
