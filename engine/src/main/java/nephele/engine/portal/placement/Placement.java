package nephele.engine.portal.placement;

import java.util.List;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import java.util.function.UnaryOperator;
import nephele.engine.level.placed.StaticShape;
import nephele.engine.math.Basis;
import nephele.engine.math.Directions;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.RayHit;
import nephele.engine.portal.Aperture;
import nephele.engine.portal.Obstacles;
import nephele.engine.portal.Portal;
import nephele.engine.portal.placement.PlacementResult.Refusal;

/**
 * Decides where a shot's portal goes: on the first surface hit, at the legal place nearest to the aimed point. A place
 * is legal if the whole aperture is in the surface's region and overlaps no other portal: {@link RegionFit}; on terrain,
 * {@link GroundPlacement}. With {@link ShotAids} it slides on to the floor or turns to the surface's edges. One object
 * serves one gun and fixed surfaces for any number of queries; the answer depends only on the query. One for each thread.
 */
public final class Placement {
    /** Least cosine of incidence; a flatter ray would hit the fitted plane at a place decided by rounding. */
    private static final double LEAST_INCIDENCE = 1e-4;

    /** Distance from which a portal is viewed in {@link #holds}; a portal farther from its wall does not touch it. */
    private static final double HOLDS_FROM_METRES = 0.02;

    /** Greatest change of place for a surface with another triangulation. */
    private static final double SAME_PLACE_METRES = 5e-5;

    private static final double DROP_ROUNDING_METRES = 1e-9;

    /** A portal's lower edge this near the floor is on it. */
    private static final double ON_FLOOR_METRES = 1e-3;

    /** Greatest height of a lower edge above the floor that is better than none: a skirting board, a floor that falls. */
    private static final double MOST_SILL_METRES = 0.1;

    /** Height over the lower edge from which rays start, so that they find floors that rise from the wall. */
    private static final double OVER_EDGE_METRES = 0.2;

    /** Distances of the rays from the wall: the narrowest ledge to stand on, and the middle of a player at the wall. */
    private static final double[] FLOOR_BEFORE_METRES = {0.08, 0.3};

    /** Places of the rays along the lower edge, in half widths; the first has to find a floor. */
    private static final double[] FLOOR_ALONG = {0, -0.45, 0.45, -0.95, 0.95};

    /** Distance of further rays that find how steep a body is. */
    private static final double SLOPE_BASE_METRES = 0.02;

    private final PlacementSurfaces surfaces;
    private final Gun gun;
    private final ShotAids aids;
    /** Greatest height above a floor from which a portal on a wall slides down to it; 0 for none. */
    private final double dropMetres;

    private final RayHit hit = new RayHit();
    private final RayHit floor = new RayHit();
    private final RegionFit onRegion;
    private final GroundPlacement ground;

    /** Creates a placement for one gun among fixed surfaces, without aids. */
    public Placement(PlacementSurfaces surfaces, Gun gun) {
        this(surfaces, gun, ShotAids.NONE);
    }

    private Placement(PlacementSurfaces surfaces, Gun gun, ShotAids aids) {
        this.surfaces = surfaces;
        this.gun = gun;
        this.aids = aids;
        dropMetres = gun.toFloor() ? aids.dropMetres() : 0;
        onRegion = new RegionFit(gun);
        ground = new GroundPlacement(surfaces, gun, onRegion);
    }

    /** Returns a placement for the same gun with these aids, as far as the gun allows them. */
    public Placement with(ShotAids others) {
        return new Placement(surfaces, gun, others);
    }

    /**
     * Returns the result of a shot.
     *
     * @param id of the new portal
     * @param others portals that stay open
     * @param moving other obstacles of the shot
     */
    public PlacementResult place(String id, ShotRay aim, List<Portal> others, Obstacles moving) {
        Ray ray = Ray.of(aim.eye(), aim.direction());
        PlacementResult missed = missed(ray, aim, moving);
        Shot shot = new Shot(id, ray, hit, normal -> PortalUpright.on(normal, aim.view()), others);
        return missed != null ? missed : onHit(shot, (region, where) -> aided(shot, region, where, aim.view(), moving));
    }

    /**
     * A shot that hits a fixed surface.
     *
     * @param upright returns the portal's up direction for its normal
     */
    record Shot(String id, Ray ray, RayHit hit, UnaryOperator<Vec3> upright, List<Portal> others) {
        Vec3 where() {
            return ray.at(hit.distance());
        }
    }

    /** Finds the fixed surface that a ray hits; returns {@code null} if there is one in range and nothing before it. */
    private PlacementResult missed(Ray ray, ShotRay aim, Obstacles moving) {
        boolean hits = surfaces.first(ray, hit);
        double limit = Math.min(gun.rangeMetres(), hits ? hit.distance() : Double.POSITIVE_INFINITY);
        double moved = metresTo(moving, aim.eye(), aim.direction(), limit);
        if (moved <= limit) {
            return new PlacementResult.Refused(Refusal.MOVING_SURFACE, ray.at(moved));
        }
        return hits && hit.distance() <= gun.rangeMetres()
                ? null
                : new PlacementResult.Refused(
                        hits ? Refusal.OUT_OF_RANGE : Refusal.NOTHING_HIT, ray.at(gun.rangeMetres()));
    }

    /** Returns the distance along a unit direction to the first moving obstacle; infinity for none before the limit. */
    private static double metresTo(Obstacles moving, Vec3 from, Vec3 direction, double limitMetres) {
        double fraction = moving.free(from.toVector(), direction.toVector().mul(limitMetres));
        return fraction < 1 ? fraction * limitMetres : Double.POSITIVE_INFINITY;
    }

    /** @param fitting returns the result of an aim at a point of a region */
    private PlacementResult onHit(Shot shot, BiFunction<Region, Vec3, PlacementResult> fitting) {
        StaticShape.HeightGrid terrain = surfaces.ground(hit.item());
        if (terrain != null && terrain.authored().portalable()) {
            return ground.place(shot, terrain.field());
        }
        Region region = terrain != null ? null : surfaces.region(shot.ray(), hit.item());
        if (region == null) {
            return new PlacementResult.Refused(Refusal.NOT_PORTALABLE, shot.where());
        }
        return fitting.apply(region, onPlane(region.frame(), shot.ray(), shot.where()));
    }

    private PlacementResult nearest(Shot shot, Region region, Vec3 where) {
        return onRegion.fit(shot.id(), region, where, shot.upright(), shot.others());
    }

    private PlacementResult aided(Shot shot, Region region, Vec3 where, Basis view, Obstacles moving) {
        Vec3 normal = region.frame().normal();
        if (slidesDown(normal)) {
            Portal aimed =
                    onRegion.over(shot.id(), region, where, shot.upright().apply(normal));
            return lowered(aimed, nearest(shot, region, where), point -> nearest(shot, region, point), moving);
        }
        if (aids.turnRadians() > 0 && PortalUpright.followsView(normal)) {
            double edge = gun.aperture().widthMetres();
            UnaryOperator<Vec3> turn = ahead -> region.nearestAxis(ahead, edge, aids.turnRadians());
            UnaryOperator<Vec3> turned = along -> PortalUpright.on(along, view, turn);
            PlacementResult result = onRegion.fit(shot.id(), region, where, turned, shot.others());
            if (result instanceof PlacementResult.Fits) {
                return result;
            }
        }
        return nearest(shot, region, where);
    }

    /** Returns true if portals on a surface slide down: it is neither a floor nor nearly a ceiling. */
    private boolean slidesDown(Vec3 normal) {
        return dropMetres > 0 && Math.abs(normal.y()) < aids.leastFloorY();
    }

    /**
     * Slides the portal of a shot at a wall down to the floor before it, so that it can be walked into. Rays down along
     * the wall, before the portal's lower edge, find the floor: what is fixed, or where there is none, the bodies.
     *
     * @param aimed the portal over the aimed point
     * @param nearest where it fits
     * @param fit returns the result of an aim at another point of the wall
     * @return the portal on the floor under the aimed one or under the nearest one that fits; the nearest result if there
     *     is no floor or no place on it
     */
    private PlacementResult lowered(
            Portal aimed, PlacementResult nearest, Function<Vec3, PlacementResult> fit, Obstacles moving) {
        Portal fitting = nearest instanceof PlacementResult.Fits fits ? fits.portal() : null;
        double sill = fitting == null ? Double.POSITIVE_INFINITY : sillMetres(fitting, moving);
        if (sill <= ON_FLOOR_METRES) {
            return nearest;
        }
        double most = Double.isNaN(sill) ? MOST_SILL_METRES : Math.min(sill - ON_FLOOR_METRES, MOST_SILL_METRES);
        Portal low = onFloor(aimed, most, fit, moving);
        if (low == null && fitting != null) {
            low = onFloor(fitting, most, fit, moving);
        }
        return low == null
                ? nearest
                : new PlacementResult.Fits(
                        low, low.centre().minus(aimed.centre()).length());
    }

    /**
     * Returns the portal that fits on the floor under another one.
     *
     * @param most greatest height of its lower edge above the floor
     * @return {@code null} if there is none
     */
    private Portal onFloor(Portal over, double most, Function<Vec3, PlacementResult> fit, Obstacles moving) {
        double sill = sillMetres(over, moving);
        if (Double.isNaN(sill) || sill > reach()) {
            return null;
        }
        Portal low = fitted(over, sill, fit);
        double left = low == null ? Double.NaN : sillMetres(low, moving);
        if (left > ON_FLOOR_METRES) {
            // It has slid along a wall whose floor is not level.
            low = fitted(low, left, fit);
            left = low == null ? Double.NaN : sillMetres(low, moving);
        }
        return left <= most ? low : null;
    }

    /** Returns the greatest height above a floor from which a portal slides down. */
    private double reach() {
        return dropMetres + DROP_ROUNDING_METRES;
    }

    private static Portal fitted(Portal over, double sill, Function<Vec3, PlacementResult> fit) {
        Vec3 up = over.frame().up();
        PlacementResult placed = fit.apply(over.centre().addScaled(-sill / up.y(), up));
        return placed instanceof PlacementResult.Fits fits ? fits.portal() : null;
    }

    /** Returns the height of a portal's lower edge above the highest floor under it; NaN without one in reach. */
    private double sillMetres(Portal portal, Obstacles moving) {
        double reach = OVER_EDGE_METRES + reach() / portal.frame().up().y();
        double sill = sillMetres(portal, down -> fixed(down, reach));
        return Double.isNaN(sill) ? sillMetres(portal, down -> body(down, reach, moving)) : sill;
    }

    /** @param floor returns the height of the walkable surface that a ray of unit direction hits; NaN for none */
    private static double sillMetres(Portal portal, ToDoubleFunction<Ray> floor) {
        Vec3 down = portal.frame().up().negated();
        double half = portal.aperture().widthMetres() / 2;
        double lower = -portal.aperture().heightMetres() / 2;
        double highest = Double.NaN;
        for (double along : FLOOR_ALONG) {
            for (double before : FLOOR_BEFORE_METRES) {
                Ray ray = Ray.of(portal.world(along * half, lower + OVER_EDGE_METRES, before), down);
                double y = floor.applyAsDouble(ray);
                highest = Double.isNaN(highest) || y > highest ? y : highest;
            }
            if (Double.isNaN(highest)) {
                return Double.NaN;
            }
        }
        return portal.world(0, lower, 0).y() - highest;
    }

    private double fixed(Ray down, double reach) {
        boolean isFloor = surfaces.first(down, floor)
                && floor.distance() <= reach
                && surfaces.upwards(down, floor.item()) >= aids.leastFloorY();
        return isFloor ? down.at(floor.distance()).y() : Double.NaN;
    }

    private double body(Ray down, double reach, Obstacles moving) {
        double y = bodyY(down, Vec3.ZERO, reach, moving);
        double x = bodyY(down, new Vec3(SLOPE_BASE_METRES, 0, 0), reach, moving) - y;
        double z = bodyY(down, new Vec3(0, 0, SLOPE_BASE_METRES), reach, moving) - y;
        double upwards = SLOPE_BASE_METRES / Math.sqrt(SLOPE_BASE_METRES * SLOPE_BASE_METRES + x * x + z * z);
        return upwards >= aids.leastFloorY() ? y : Double.NaN;
    }

    private static double bodyY(Ray down, Vec3 aside, double reach, Obstacles moving) {
        Vec3 start = down.at(0).plus(aside);
        Vec3 direction = new Vec3(down.directionX(), down.directionY(), down.directionZ());
        double depth = metresTo(moving, start, direction, reach);
        return depth <= reach ? start.y() + depth * direction.y() : Double.NaN;
    }

    /**
     * Returns true if a shot straight at a portal's centre would place it where it is, among the current surfaces. The
     * portal keeps its own up direction: that of slopes depended on a view that is not known any more.
     */
    public boolean holds(Portal portal, List<Portal> others) {
        ShotRay straight = new ShotRay(portal.world(0, 0, HOLDS_FROM_METRES), portal.frame());
        Ray ray = Ray.of(straight.eye(), straight.direction());
        if (missed(ray, straight, Obstacles.NONE) != null) {
            return false;
        }
        Shot shot = new Shot(portal.id(), ray, hit, normal -> keptUp(portal.frame(), normal), others);
        PlacementResult again = onHit(shot, (region, where) -> nearest(shot, region, where));
        return again instanceof PlacementResult.Fits fits
                && isSame(fits.portal().aperture(), portal.aperture())
                && fits.portal().centre().toVector().distance(portal.centre().toVector()) <= SAME_PLACE_METRES
                && fits.portal().normal().dot(portal.normal()) >= Tolerance.COPLANAR_COSINE
                && fits.portal().frame().up().dot(portal.frame().up()) >= Tolerance.COPLANAR_COSINE;
    }

    /** Returns a portal's own up direction, turned into the plane with a normal. */
    private static Vec3 keptUp(Basis frame, Vec3 normal) {
        Vec3 up = Directions.unit(frame.up().addScaled(-frame.up().dot(normal), normal));
        return up == null ? PortalUpright.on(normal, frame) : up;
    }

    private static boolean isSame(Aperture a, Aperture b) {
        return a.shape() == b.shape() && a.widthMetres() == b.widthMetres() && a.heightMetres() == b.heightMetres();
    }

    /**
     * Returns the intersection of the ray with the region's own plane, which is less noisy than that of the face that
     * it hit.
     */
    static Vec3 onPlane(PlaneFrame frame, Ray ray, Vec3 hit) {
        Vec3 direction = new Vec3(ray.directionX(), ray.directionY(), ray.directionZ());
        double rate = frame.normal().dot(direction);
        if (rate > -LEAST_INCIDENCE) {
            return hit;
        }
        double back = frame.height(hit) / rate;
        return hit.addScaled(-back, direction);
    }
}
