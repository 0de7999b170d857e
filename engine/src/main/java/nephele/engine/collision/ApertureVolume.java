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
import nephele.engine.portal.ground.GroundSeat;

/**
 * The aperture volume: the hole in this side's solids behind an open portal. It is the aperture's own prism for the
 * first {@link #FRAME_METRES}, then a box so wide and deep that no body with its centre in front of the portal reaches
 * its end. What is left of the wall at the portal's plane is a thin, exact frame, with room behind it for the other
 * side's solids. On uneven ground the frame reaches down to the ground around.
 */
final class ApertureVolume {
    /** Thickness of the frame that is left of the wall. */
    static final double FRAME_METRES = 5e-4;

    /** Portals whose unit normals differ by less face the same way. */
    private static final double SAME_DIRECTION_SINE = 0.05;

    private final int portal;
    private final double reachMetres;
    private final boolean isOnGround;
    private final Plane front;
    private final Plane frameEnd;
    private final List<Plane> throat;
    private final List<Plane> chamber;
    private final Aabb bounds;

    /**
     * Makes the volume behind a portal.
     *
     * @param index of the portal
     * @param reachMetres depth of the volume, and its margin around the aperture
     * @param stepMetres how far the ground around lies below the portal, see {@link GroundSeat#stepMetres}
     * @param shared planes that separate it from the volumes of other portals; it is on their negative side
     */
    ApertureVolume(int index, Portal portal, double reachMetres, double stepMetres, List<Plane> shared) {
        this.portal = index;
        this.reachMetres = reachMetres;
        front = behind(portal, 0);
        isOnGround = stepMetres >= 0;
        frameEnd = behind(portal, FRAME_METRES + Math.max(0, stepMetres));
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
        chamber.add(behind(portal, reachMetres).opposite());
        bounds = bounds(portal, x, y, reachMetres);
    }

    /** Returns the plane at a distance behind the portal, with the portal's normal. */
    private static Plane behind(Portal portal, double metres) {
        return Plane.through(portal.normal(), portal.world(0, 0, -metres));
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
        return Plane.through(normal, portal.world(x * metres, y * metres, 0));
    }

    private static Aabb bounds(Portal portal, double x, double y, double reach) {
        List<Vec3> corners = new ArrayList<>();
        for (int i = 0; i < 8; i++) {
            corners.add(portal.world((i & 1) == 0 ? x : -x, (i & 2) == 0 ? y : -y, (i & 4) == 0 ? 0 : -reach));
        }
        return Aabb.of(corners);
    }

    /** Returns the index of the portal. */
    int portal() {
        return portal;
    }

    double reachMetres() {
        return reachMetres;
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

    /**
     * Adds the parts of a triangle of ground outside the volume. That of a portal on ground takes only the aperture's
     * prism out of it, however far it falls away: what is beside the portal carries bodies.
     */
    void carveGround(ConvexPolyhedron triangle, List<ConvexPolyhedron> left) {
        if (!isOnGround) {
            carve(triangle, left);
            return;
        }
        PolyhedronCut atFront = PolyhedronCut.of(triangle, front);
        add(atFront.inFront(), left);
        if (atFront.behind() != null) {
            takeOut(atFront.behind(), throat, left);
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

    /**
     * Returns the plane behind which the first portal's volume lies, where both volumes would overlap: points beyond it are
     * deeper behind the second portal. Between portals side by side in one wall it is the middle between them.
     *
     * @return {@code null} if one aperture covers the other
     */
    static Plane dividing(Portal a, Portal b) {
        Vec3 difference = a.normal().minus(b.normal());
        double length = difference.length();
        if (length < SAME_DIRECTION_SINE) {
            return sideBySide(a, b);
        }
        Vec3 unit = new Vec3(difference.x() / length, difference.y() / length, difference.z() / length);
        // n · (p − a) = m · (p − b), taken at a's centre, where the numbers are small.
        double atCentre = b.inFront(a.centre().x(), a.centre().y(), a.centre().z()) / length;
        Vec3 point = a.centre().addScaled(atCentre, unit);
        return Plane.through(unit, point);
    }

    /** Two convex polygons that do not overlap are separated along the normal of an edge. */
    private static Plane sideBySide(Portal a, Portal b) {
        Plane fromA = widestGap(a, b);
        Plane fromB = widestGap(b, a);
        if (fromA == null || fromB == null) {
            return fromA != null || fromB == null ? fromA : fromB.opposite();
        }
        return gap(fromA, a, b) >= gap(fromB.opposite(), a, b) ? fromA : fromB.opposite();
    }

    private static Plane widestGap(Portal a, Portal b) {
        Plane best = null;
        double widest = -1e-9;
        for (int i = 0; i < a.aperture().corners(); i++) {
            Vec3 on = a.world(a.aperture().cornerX(i), a.aperture().cornerY(i), 0);
            Plane edge = Plane.through(edgeNormal(a, i), on);
            double nearest = least(edge, b);
            if (nearest > widest) {
                widest = nearest;
                best = new Plane(edge.nx(), edge.ny(), edge.nz(), edge.distance() + nearest / 2);
            }
        }
        return best;
    }

    private static Vec3 edgeNormal(Portal portal, int edge) {
        Vec3 origin = portal.centre();
        Vec3 end = portal.world(
                portal.aperture().edgeNormalX(edge), portal.aperture().edgeNormalY(edge), 0);
        return end.minus(origin);
    }

    private static double gap(Plane plane, Portal a, Portal b) {
        return least(plane, b) + least(plane.opposite(), a);
    }

    private static double least(Plane plane, Portal portal) {
        return portal.corners().stream()
                .mapToDouble(plane::signedDistance)
                .min()
                .orElse(0);
    }
}
