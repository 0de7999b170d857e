package nephele.engine.portal.placement;

import java.util.List;
import java.util.function.UnaryOperator;
import nephele.engine.level.placed.StaticShape;
import nephele.engine.math.Basis;
import nephele.engine.math.Directions;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.RayHit;
import nephele.engine.portal.Aperture;
import nephele.engine.portal.Portal;

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
        UnaryOperator<Vec3> upright = normal -> PortalUpright.on(normal, aim.view());
        return place(new Shot(id, aim, upright, others, moving), this::aided);
    }

    /** @param upright returns the portal's up direction for its normal */
    private record Shot(
            String id, ShotRay aim, UnaryOperator<Vec3> upright, List<Portal> others, MovingSurfaces moving) {}

    /** Finds the place of a shot that aims at a point of a region. */
    @FunctionalInterface
    private interface Fitting {
        PlacementResult fit(Shot shot, Region region, Vec3 where);
    }

    private PlacementResult place(Shot shot, Fitting fitting) {
        ShotRay aim = shot.aim();
        Vec3 direction = aim.direction();
        Ray ray = Ray.of(aim.eye(), direction);
        boolean hits = surfaces.first(ray, hit);
        double limit = Math.min(gun.rangeMetres(), hits ? hit.distance() : Double.POSITIVE_INFINITY);
        double moved = shot.moving().distance(aim.eye(), direction, limit);
        if (moved <= limit) {
            return new PlacementResult.Refused(Refusal.MOVING_SURFACE, ray.at(moved));
        }
        if (!hits || hit.distance() > gun.rangeMetres()) {
            return new PlacementResult.Refused(
                    hits ? Refusal.OUT_OF_RANGE : Refusal.NOTHING_HIT, ray.at(gun.rangeMetres()));
        }
        Vec3 where = ray.at(hit.distance());
        StaticShape.HeightGrid terrain = surfaces.ground(hit.item());
        if (terrain != null && terrain.said().portalable()) {
            var onGround = new GroundPlacement.Shot(shot.id(), ray, hit, where, shot.upright(), shot.others());
            return ground.place(onGround, terrain.field());
        }
        Region region = terrain != null ? null : surfaces.region(ray, hit.item());
        if (region == null) {
            return new PlacementResult.Refused(Refusal.NOT_PORTALABLE, where);
        }
        return fitting.fit(shot, region, onPlane(region.frame(), ray, where));
    }

    private PlacementResult nearest(Shot shot, Region region, Vec3 where) {
        return onRegion.fit(shot.id(), region, where, shot.upright(), shot.others());
    }

    private PlacementResult aided(Shot shot, Region region, Vec3 where) {
        Vec3 normal = region.frame().normal();
        if (drop.isFor(normal)) {
            Portal aimed =
                    onRegion.over(shot.id(), region, where, shot.upright().apply(normal));
            return drop.lowered(
                    aimed, nearest(shot, region, where), point -> nearest(shot, region, point), shot.moving());
        }
        if (aids.turnRadians() > 0 && PortalUpright.followsView(normal)) {
            double edge = gun.aperture().widthMetres();
            UnaryOperator<Vec3> turn = ahead -> SurfaceAxes.nearest(region, ahead, edge, aids.turnRadians());
            UnaryOperator<Vec3> turned =
                    along -> PortalUpright.on(along, shot.aim().view(), turn);
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
        UnaryOperator<Vec3> upright = normal -> keptUp(portal.frame(), normal);
        PlacementResult again =
                place(new Shot(portal.id(), straight, upright, others, MovingSurfaces.NONE), this::nearest);
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
