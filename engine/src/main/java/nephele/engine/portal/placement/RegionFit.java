package nephele.engine.portal.placement;

import java.util.List;
import java.util.function.UnaryOperator;
import nephele.engine.math.Aabb;
import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.ItemList;
import nephele.engine.portal.Aperture;
import nephele.engine.portal.Portal;
import nephele.engine.portal.placement.PlacementResult.Refusal;

/**
 * Fits an aperture on a region at the legal place nearest to a point. A {@link CentreSearch} is given the obstacles: the
 * region's outline, what bars it, and other portals.
 */
final class RegionFit {
    /** Least reach from which a search for any place extends, for a gun whose portals do not slide. */
    private static final double LEAST_REACH_METRES = 0.05;

    /** Factor by which each further search for any place extends. */
    private static final double WIDEN = 2;

    /**
     * Greatest number of limits in a search for any place: beyond, the place would be far away, and a query must be
     * short.
     */
    private static final int MOST_LIMITS = 100;

    private final Gun gun;
    private final CentreSearch centres = new CentreSearch();
    private final ItemList found = new ItemList();

    RegionFit(Gun gun) {
        this.gun = gun;
    }

    /** Returns true if a portal over a point needs no slide. */
    boolean allows(Region region, Vec3 where, UnaryOperator<Vec3> upright, List<Portal> others) {
        PlaneFrame frame = region.frame();
        double x = frame.x(where);
        double y = frame.y(where);
        if (region.isBarred(x, y, found)) {
            return false;
        }
        collectObstacles(region, reflected(frame, upright.apply(frame.normal())), x, y, 0);
        others.forEach(other -> addObstacle(frame, other));
        return centres.find(region, x, y, 0);
    }

    private ConvexPolygon reflected(PlaneFrame frame, Vec3 up) {
        return ConvexPolygon.reflected(gun.aperture(), frame.xOf(up), frame.yOf(up));
    }

    /**
     * Returns a portal that slides as far as the gun's do.
     *
     * @param upright returns the portal's up direction for its normal
     */
    PlacementResult fit(String id, Region region, Vec3 where, UnaryOperator<Vec3> upright, List<Portal> others) {
        PlaneFrame frame = region.frame();
        double x = frame.x(where);
        double y = frame.y(where);
        if (region.isBarred(x, y, found)) {
            return new PlacementResult.Refused(Refusal.NOT_PORTALABLE, where);
        }
        Vec3 up = upright.apply(frame.normal());
        ConvexPolygon reflected = reflected(frame, up);
        collectObstacles(region, reflected, x, y, gun.slideMetres());
        for (Portal other : others) {
            addObstacle(frame, other);
        }
        if (centres.find(region, x, y, gun.slideMetres())) {
            Vec3 centre = frame.world(centres.x(), centres.y());
            return new PlacementResult.Fits(over(id, region, centre, up), centres.distance());
        }
        return new PlacementResult.Refused(refusal(region, reflected, x, y, !others.isEmpty()), where);
    }

    /** Returns the portal over a point of a region, whether or not it fits there. */
    Portal over(String id, Region region, Vec3 centre, Vec3 up) {
        PlaneFrame frame = region.frame();
        Basis axes = new Basis(frame.worldDirection(frame.yOf(up), -frame.xOf(up)), up, frame.normal());
        return new Portal(id, centre, axes, gun.aperture());
    }

    private Refusal refusal(Region region, ConvexPolygon reflected, double x, double y, boolean maybeOthers) {
        if (maybeOthers) {
            collectObstacles(region, reflected, x, y, gun.slideMetres());
            if (centres.find(region, x, y, gun.slideMetres())) {
                return Refusal.OVERLAPS_OTHER;
            }
        }
        double farthest = farthest(region.faces().bounds(), x, y);
        boolean small = region.outline().size() + region.bars().size() <= MOST_LIMITS;
        double reach = Math.max(gun.slideMetres(), LEAST_REACH_METRES);
        while (reach < farthest) {
            reach = small ? farthest : Math.min(WIDEN * reach, farthest);
            collectObstacles(region, reflected, x, y, reach);
            if (centres.polygons() > MOST_LIMITS || centres.find(region, x, y, reach)) {
                return Refusal.EDGE;
            }
        }
        return Refusal.TOO_SMALL;
    }

    private static double farthest(Aabb box, double x, double y) {
        double dx = Math.max(x - box.minX(), box.maxX() - x);
        double dy = Math.max(y - box.minY(), box.maxY() - y);
        return Math.sqrt(dx * dx + dy * dy);
    }

    /** Collects all obstacles that matter for centres within {@code metres} of a point. */
    private void collectObstacles(Region region, ConvexPolygon reflected, double x, double y, double metres) {
        centres.begin(reflected);
        Aabb box = reflected.bounds();
        double reachX = metres + Math.max(-box.minX(), box.maxX());
        double reachY = metres + Math.max(-box.minY(), box.maxY());
        Aabb reach = new Aabb(x - reachX, y - reachY, 0, x + reachX, y + reachY, 0);
        found.clear();
        region.outline().overlapping(reach, found);
        found.sort();
        for (int i = 0; i < found.size(); i++) {
            centres.addOutline(region.outline().shape(found.get(i)));
        }
        found.clear();
        region.bars().overlapping(reach, found);
        found.sort();
        for (int i = 0; i < found.size(); i++) {
            centres.add(region.bars().shape(found.get(i)));
        }
    }

    /** Adds another portal, if it is in the same plane and faces the same direction. */
    private void addObstacle(PlaneFrame frame, Portal other) {
        if (frame.normal().dot(other.normal()) < Tolerance.COPLANAR_COSINE
                || Math.abs(frame.height(other.centre())) > Tolerance.COPLANAR) {
            return;
        }
        Aperture aperture = other.aperture();
        double x = frame.x(other.centre());
        double y = frame.y(other.centre());
        Vec3 right = other.frame().right();
        Vec3 up = other.frame().up();
        double[] corners = new double[2 * aperture.corners()];
        for (int i = 0; i < aperture.corners(); i++) {
            double across = aperture.cornerX(i);
            double upward = aperture.cornerY(i);
            corners[2 * i] = x + across * frame.xOf(right) + upward * frame.xOf(up);
            corners[2 * i + 1] = y + across * frame.yOf(right) + upward * frame.yOf(up);
        }
        centres.add(ConvexPolygon.of(corners));
    }
}
