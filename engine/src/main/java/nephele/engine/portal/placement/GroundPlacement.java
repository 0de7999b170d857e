package nephele.engine.portal.placement;

import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;
import nephele.engine.math.Aabb;
import nephele.engine.math.Basis;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.RayHit;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.math.heightfield.HeightFieldSurface;
import nephele.engine.portal.Aperture;
import nephele.engine.portal.Portal;
import nephele.engine.portal.ground.GroundSeat;
import nephele.engine.portal.ground.GroundSheet;

/**
 * Fits portals on terrains, at a {@link GroundSeat} that nothing bars: over the aimed point if possible, otherwise over
 * the nearest of some points around it. These are where the portal slides to on the aimed point's plane or on flat
 * ground, and places on circles.
 */
final class GroundPlacement {
    private static final int CIRCLES = 6;
    private static final int PLACES = 12;

    /** Radius of the last circle in slides; the ground there is a little farther away. */
    private static final double WIDEST = 0.99;

    /** Further slide from an obstacle, since the plane over the place slid to differs a little. */
    private static final double CLEAR_METRES = 2e-3;

    /** Distance before the ground from which rays look for it. */
    private static final double BEFORE_METRES = 0.05;

    /** Planes of portals this near to each other overlap, if they face similar ways. */
    private static final double NEAR_PLANE_METRES = 0.05;

    private static final double SIMILAR_COSINE = 0.5;

    private final PlacementSurfaces surfaces;
    private final Gun gun;
    private final RegionFit fit;
    private final double reach;

    /**
     * A shot that hits a terrain.
     *
     * @param upright returns the portal's up direction for its normal
     */
    record Shot(String id, Ray ray, RayHit hit, Vec3 where, UnaryOperator<Vec3> upright, List<Portal> others) {}

    /** A portal that fits, with its distance from the aimed point. */
    private record Place(Portal portal, double metres) {}

    GroundPlacement(PlacementSurfaces surfaces, Gun gun, RegionFit fit) {
        this.surfaces = surfaces;
        this.gun = gun;
        this.fit = fit;
        Aperture aperture = gun.aperture();
        reach = gun.slideMetres() + aperture.widthMetres() + aperture.heightMetres();
    }

    PlacementResult place(Shot shot, HeightField field) {
        GroundSeat aimed = seat(shot, field, shot.where());
        Place place = null;
        Refusal reason = Refusal.NOT_FLAT;
        if (aimed.isEven()) {
            if (isFree(shot, field, aimed.portal())) {
                return new PlacementResult.Fits(aimed.portal(), 0);
            }
            PlacementResult slid = slid(shot, field, aimed.portal());
            if (slid instanceof PlacementResult.Refused refused) {
                reason = refused.reason() == Refusal.TOO_SMALL ? Refusal.EDGE : refused.reason();
            } else {
                place = settled(shot, field, ((PlacementResult.Fits) slid).portal());
            }
        }
        place = nearer(place, onFlat(shot, field));
        place = nearer(place, onCircles(shot, field, aimed.portal().frame(), place));
        if (place != null) {
            return new PlacementResult.Fits(place.portal(), place.metres());
        }
        double uneven = reason == Refusal.NOT_FLAT ? aimed.measuredUneven(field) : 0;
        return new PlacementResult.Refused(reason, shot.where(), uneven);
    }

    private static Place nearer(Place a, Place b) {
        return b == null || a != null && a.metres() <= b.metres() ? a : b;
    }

    private GroundSeat seat(Shot shot, HeightField field, Vec3 on) {
        return GroundSeat.over(field, on, shot.id(), gun.aperture(), shot.upright());
    }

    /** Returns true if nothing else is where a portal would be. */
    private boolean isFree(Shot shot, HeightField field, Portal portal) {
        Region region = region(portal, field);
        return region != null && fit.allows(region, portal.centre(), shot.upright(), flattened(shot.others(), portal));
    }

    private PlacementResult slid(Shot shot, HeightField field, Portal portal) {
        Region region = region(portal, field);
        return region == null
                ? new PlacementResult.Refused(Refusal.EDGE, shot.where())
                : fit.fit(shot.id(), region, portal.centre(), shot.upright(), flattened(shot.others(), portal));
    }

    /** Returns the plane of a portal as a surface; {@code null} if something else is over the portal's centre. */
    private Region region(Portal portal, HeightField field) {
        List<Vec3> sheet = GroundSheet.around(portal, reach, field);
        if (sheet.size() < 3) {
            return null;
        }
        Aabb box = Aabb.of(sheet).grown(NEAR_PLANE_METRES);
        Ray inwards = Ray.of(portal.world(0, 0, BEFORE_METRES), portal.normal().negated());
        return GroundRegion.grown(inwards, List.of(new SurfacePolygon(sheet, true)), surfaces.near(box), box);
    }

    /** Returns the other portals that are near a portal's plane, projected on it. */
    private static List<Portal> flattened(List<Portal> others, Portal plane) {
        List<Portal> flat = new ArrayList<>();
        for (Portal other : others) {
            double least = Double.POSITIVE_INFINITY;
            double greatest = Double.NEGATIVE_INFINITY;
            for (Vec3 corner : other.corners()) {
                double height = plane.inFront(corner.x(), corner.y(), corner.z());
                least = Math.min(least, height);
                greatest = Math.max(greatest, height);
            }
            if (other.normal().dot(plane.normal()) >= SIMILAR_COSINE
                    && least <= NEAR_PLANE_METRES
                    && greatest >= -NEAR_PLANE_METRES) {
                Vec3 centre = other.centre();
                double height = plane.inFront(centre.x(), centre.y(), centre.z());
                Basis axes = new Basis(other.frame().right(), other.frame().up(), plane.normal());
                flat.add(new Portal(other.id(), centre.addScaled(-height, plane.normal()), axes, other.aperture()));
            }
        }
        return flat;
    }

    /** Returns the place over the ground behind a portal, or a little beyond it; {@code null} if neither is free. */
    private Place settled(Shot shot, HeightField field, Portal portal) {
        Place place = over(shot, field, behind(field, portal));
        if (place != null) {
            return place;
        }
        Vec3 way = portal.centre().minus(shot.where());
        Vec3 beyond = portal.centre().addScaled(CLEAR_METRES / way.length(), way);
        return over(shot, field, behind(field, new Portal(portal.id(), beyond, portal.frame(), portal.aperture())));
    }

    /** Returns the point of the ground behind a portal's centre; {@code null} for none. */
    private static Vec3 behind(HeightField field, Portal portal) {
        Ray ray = Ray.of(portal.world(0, 0, BEFORE_METRES), portal.normal().negated());
        RayHit hit = new RayHit();
        boolean isHit = field.nearest(ray, 2 * BEFORE_METRES, (r, triangle, limit) -> field.entry(r, triangle), hit);
        return isHit ? ray.at(hit.distance()) : null;
    }

    /** Returns the place over a point of the ground; {@code null} if there is none or it is too far away. */
    private Place over(Shot shot, HeightField field, Vec3 on) {
        double metres =
                on == null ? Double.POSITIVE_INFINITY : on.minus(shot.where()).length();
        if (metres > gun.slideMetres()) {
            return null;
        }
        GroundSeat seat = seat(shot, field, on);
        return seat.isEven() && isFree(shot, field, seat.portal()) ? new Place(seat.portal(), metres) : null;
    }

    /** Returns the place on ground that is as flat as a wall. */
    private Place onFlat(Shot shot, HeightField field) {
        Aperture aperture = gun.aperture();
        Region region =
                surfaces.groundRegion(shot.ray(), shot.hit(), reach, aperture.widthMetres() * aperture.heightMetres());
        if (region == null) {
            return null;
        }
        Vec3 where = Placement.onPlane(region.frame(), shot.ray(), shot.where());
        PlacementResult result = fit.fit(shot.id(), region, where, shot.upright(), shot.others());
        if (!(result instanceof PlacementResult.Fits flat)) {
            return null;
        }
        Place place = over(shot, field, behind(field, flat.portal()));
        return place != null ? place : new Place(flat.portal(), flat.slideMetres());
    }

    /** Returns the first free place on circles around the aimed point, if it is nearer than one that is known. */
    private Place onCircles(Shot shot, HeightField field, Basis axes, Place known) {
        for (int circle = 1; circle <= CIRCLES; circle++) {
            double radius = WIDEST * gun.slideMetres() * circle / CIRCLES;
            if (known != null && known.metres() <= radius) {
                return null;
            }
            for (int place = 0; place < PLACES; place++) {
                double angle = 2 * Math.PI * place / PLACES;
                Vec3 near = shot.where()
                        .addScaled(radius * StrictMath.cos(angle), axes.right())
                        .addScaled(radius * StrictMath.sin(angle), axes.up());
                double y = HeightFieldSurface.y(field, near.x(), near.z());
                Vec3 on = new Vec3(near.x(), y, near.z());
                boolean isPossible = !Double.isNaN(y)
                        && GroundSeat.isPossible(field, new Portal(shot.id(), on, axes, gun.aperture()));
                Place found = isPossible ? over(shot, field, on) : null;
                if (found != null) {
                    return found;
                }
            }
        }
        return null;
    }
}
