package nephele.engine.portal.placement;

import java.util.List;
import nephele.engine.level.placed.StaticShape;
import nephele.engine.math.Aabb;
import nephele.engine.math.Basis;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.ItemList;
import nephele.engine.math.bvh.RayHit;
import nephele.engine.portal.Aperture;
import nephele.engine.portal.Portal;

/**
 * Decides where a shot's portal goes: on the first surface hit, at the legal place nearest to the aimed point. A place
 * is legal if the whole aperture is in the surface's region and overlaps no other portal. {@link ForbiddenCentres} holds
 * the obstacles (the region's outline, what bars it, other portals), grown by the reflected aperture; {@link
 * NearestPoint} picks the nearest centre outside all of them. One object serves one gun and fixed surfaces for any
 * number of queries; the answer depends only on the query. One for each thread.
 */
public final class Placement {
    /** Least cosine of incidence; a flatter ray would hit the fitted plane at a place decided by rounding. */
    private static final double LEAST_INCIDENCE = 1e-4;

    /** Least reach from which a search for any place extends, for a gun whose portals do not slide. */
    private static final double LEAST_REACH_METRES = 0.05;

    /** Factor by which each further search for any place extends. */
    private static final double WIDEN = 2;

    /**
     * Greatest number of limits in a search for any place: beyond, the place would be far away, and a query must be
     * short.
     */
    private static final int MOST_LIMITS = 100;

    /** Distance from which a portal is viewed in {@link #holds}; a portal farther from its wall does not touch it. */
    private static final double HOLDS_FROM_METRES = 0.02;

    /** Greatest change of place for a surface with another triangulation. */
    private static final double SAME_PLACE_METRES = 5e-5;

    private final PlacementSurfaces surfaces;
    private final Gun gun;
    private final RayHit hit = new RayHit();
    private final ForbiddenCentres forbidden = new ForbiddenCentres();
    private final NearestPoint nearest = new NearestPoint(forbidden);
    private final ItemList found = new ItemList();

    /** Creates a placement for one gun among fixed surfaces. */
    public Placement(PlacementSurfaces surfaces, Gun gun) {
        this.surfaces = surfaces;
        this.gun = gun;
    }

    /**
     * Returns the result of a shot.
     *
     * @param id of the new portal
     * @param others portals that stay open
     * @param moving other obstacles of the shot
     */
    public PlacementResult place(String id, ShotRay aim, List<Portal> others, MovingSurfaces moving) {
        Vec3 direction = aim.direction();
        Ray ray = Ray.of(aim.eye(), direction);
        boolean hits = surfaces.first(ray, hit);
        double limit = Math.min(gun.rangeMetres(), hits ? hit.distance() : Double.POSITIVE_INFINITY);
        double moved = moving.distance(aim.eye(), direction, limit);
        if (moved <= limit) {
            return new PlacementResult.Refused(Refusal.MOVING_SURFACE, ray.at(moved));
        }
        if (!hits || hit.distance() > gun.rangeMetres()) {
            return new PlacementResult.Refused(
                    hits ? Refusal.OUT_OF_RANGE : Refusal.NOTHING_HIT, ray.at(gun.rangeMetres()));
        }
        Vec3 where = ray.at(hit.distance());
        StaticShape.HeightGrid ground = surfaces.ground(hit.item());
        if (ground != null && ground.said().portalable()) {
            return onGround(id, ray, where, aim.view(), others);
        }
        Region region = ground != null ? null : surfaces.region(ray, hit.item());
        if (region == null) {
            return new PlacementResult.Refused(Refusal.NOT_PORTALABLE, where);
        }
        return fitOnRegion(id, region, onPlane(region.frame(), ray, where), aim.view(), others);
    }

    /** Fits on a terrain: only its part around the hit is known, so there is no place farther away. */
    private PlacementResult onGround(String id, Ray ray, Vec3 where, Basis view, List<Portal> others) {
        Aperture aperture = gun.aperture();
        double reach = gun.slideMetres() + aperture.widthMetres() + aperture.heightMetres();
        Region region = surfaces.groundRegion(ray, hit, reach, aperture.widthMetres() * aperture.heightMetres());
        if (region == null) {
            return new PlacementResult.Refused(Refusal.NOT_FLAT, where);
        }
        PlacementResult result = fitOnRegion(id, region, onPlane(region.frame(), ray, where), view, others);
        boolean isUneven = result instanceof PlacementResult.Refused refused
                && (refused.reason() == Refusal.TOO_SMALL || refused.reason() == Refusal.EDGE);
        return isUneven ? new PlacementResult.Refused(Refusal.NOT_FLAT, where) : result;
    }

    /** Returns true if a shot straight at a portal's centre would place it where it is, among the current surfaces. */
    public boolean holds(Portal portal, List<Portal> others) {
        Vec3 before = portal.world(0, 0, HOLDS_FROM_METRES);
        PlacementResult again = place(portal.id(), new ShotRay(before, portal.frame()), others, MovingSurfaces.NONE);
        return again instanceof PlacementResult.Fits fits
                && isSame(fits.portal().aperture(), portal.aperture())
                && fits.portal().centre().toVector().distance(portal.centre().toVector()) <= SAME_PLACE_METRES
                && fits.portal().frame().up().dot(portal.frame().up()) >= Tolerance.COPLANAR_COSINE;
    }

    private static boolean isSame(Aperture a, Aperture b) {
        return a.shape() == b.shape() && a.widthMetres() == b.widthMetres() && a.heightMetres() == b.heightMetres();
    }

    /**
     * Returns the intersection of the ray with the region's own plane, which is less noisy than that of the face that
     * it hit.
     */
    private static Vec3 onPlane(PlaneFrame frame, Ray ray, Vec3 hit) {
        Vec3 direction = new Vec3(ray.directionX(), ray.directionY(), ray.directionZ());
        double rate = frame.normal().dot(direction);
        if (rate > -LEAST_INCIDENCE) {
            return hit;
        }
        double back = frame.height(hit) / rate;
        return hit.addScaled(-back, direction);
    }

    private PlacementResult fitOnRegion(String id, Region region, Vec3 where, Basis view, List<Portal> others) {
        PlaneFrame frame = region.frame();
        double x = frame.x(where);
        double y = frame.y(where);
        if (region.isBarred(x, y, found)) {
            return new PlacementResult.Refused(Refusal.NOT_PORTALABLE, where);
        }
        Vec3 up = PortalUpright.on(frame.normal(), view);
        double upX = frame.xOf(up);
        double upY = frame.yOf(up);
        ReflectedAperture turned = new ReflectedAperture(gun.aperture(), upX, upY);
        collectObstacles(region, turned, x, y, gun.slideMetres());
        for (Portal other : others) {
            addObstacle(frame, other);
        }
        if (nearest.find(region, x, y, gun.slideMetres())) {
            Basis axes = new Basis(frame.worldDirection(upY, -upX), up, frame.normal());
            Vec3 centre = frame.world(nearest.x(), nearest.y());
            return new PlacementResult.Fits(new Portal(id, centre, axes, gun.aperture()), nearest.distance());
        }
        return new PlacementResult.Refused(refusal(region, turned, x, y, !others.isEmpty()), where);
    }

    private Refusal refusal(Region region, ReflectedAperture turned, double x, double y, boolean maybeOthers) {
        if (maybeOthers) {
            collectObstacles(region, turned, x, y, gun.slideMetres());
            if (nearest.find(region, x, y, gun.slideMetres())) {
                return Refusal.OVERLAPS_OTHER;
            }
        }
        double farthest = farthest(region.faces().bounds(), x, y);
        boolean small = region.outline().size() + region.bars().size() <= MOST_LIMITS;
        double reach = Math.max(gun.slideMetres(), LEAST_REACH_METRES);
        while (reach < farthest) {
            reach = small ? farthest : Math.min(WIDEN * reach, farthest);
            collectObstacles(region, turned, x, y, reach);
            if (forbidden.polygons() > MOST_LIMITS || nearest.find(region, x, y, reach)) {
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
    private void collectObstacles(Region region, ReflectedAperture turned, double x, double y, double metres) {
        forbidden.begin(turned);
        double reachX = metres + turned.reachX();
        double reachY = metres + turned.reachY();
        Aabb reach = new Aabb(x - reachX, y - reachY, 0, x + reachX, y + reachY, 0);
        found.clear();
        region.outline().overlapping(reach, found);
        found.sort();
        for (int i = 0; i < found.size(); i++) {
            forbidden.addOutline(region.outline().shape(found.get(i)));
        }
        found.clear();
        region.bars().overlapping(reach, found);
        found.sort();
        for (int i = 0; i < found.size(); i++) {
            forbidden.add(region.bars().shape(found.get(i)));
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
        forbidden.add(ConvexPolygon.of(corners));
    }
}
