package nephele.engine.portal.placement;

import java.util.List;
import java.util.function.BiFunction;
import java.util.function.UnaryOperator;
import nephele.engine.level.placed.StaticShape;
import nephele.engine.math.Basis;
import nephele.engine.math.Directions;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.RayHit;
import nephele.engine.portal.Aperture;
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

    private final PlacementSurfaces surfaces;
    private final Gun gun;
    private final ShotAids aids;
    private final FloorDrop drop;
    private final RayHit hit = new RayHit();
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
        drop = new FloorDrop(surfaces, gun.toFloor() ? aids : aids.withoutDrop());
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
    public PlacementResult place(String id, ShotRay aim, List<Portal> others, MovingSurfaces moving) {
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
    private PlacementResult missed(Ray ray, ShotRay aim, MovingSurfaces moving) {
        boolean hits = surfaces.first(ray, hit);
        double limit = Math.min(gun.rangeMetres(), hits ? hit.distance() : Double.POSITIVE_INFINITY);
        double moved = moving.distance(aim.eye(), aim.direction(), limit);
        if (moved <= limit) {
            return new PlacementResult.Refused(Refusal.MOVING_SURFACE, ray.at(moved));
        }
        return hits && hit.distance() <= gun.rangeMetres()
                ? null
                : new PlacementResult.Refused(
                        hits ? Refusal.OUT_OF_RANGE : Refusal.NOTHING_HIT, ray.at(gun.rangeMetres()));
    }

    /** @param fitting returns the result of an aim at a point of a region */
    private PlacementResult onHit(Shot shot, BiFunction<Region, Vec3, PlacementResult> fitting) {
        StaticShape.HeightGrid terrain = surfaces.ground(hit.item());
        if (terrain != null && terrain.said().portalable()) {
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

    private PlacementResult aided(Shot shot, Region region, Vec3 where, Basis view, MovingSurfaces moving) {
        Vec3 normal = region.frame().normal();
        if (drop.isFor(normal)) {
            Portal aimed =
                    onRegion.over(shot.id(), region, where, shot.upright().apply(normal));
            return drop.lowered(aimed, nearest(shot, region, where), point -> nearest(shot, region, point), moving);
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

    /**
     * Returns true if a shot straight at a portal's centre would place it where it is, among the current surfaces. The
     * portal keeps its own up direction: that of slopes depended on a view that is not known any more.
     */
    public boolean holds(Portal portal, List<Portal> others) {
        ShotRay straight = new ShotRay(portal.world(0, 0, HOLDS_FROM_METRES), portal.frame());
        Ray ray = Ray.of(straight.eye(), straight.direction());
        if (missed(ray, straight, MovingSurfaces.NONE) != null) {
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
