package nephele.engine.portal.placement;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.Brush;
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
import nephele.engine.portal.placement.Placement.Shot;
import nephele.engine.portal.placement.PlacementResult.Fits;
import nephele.engine.portal.placement.PlacementResult.Refusal;

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

    /** With more triangles in reach, the cells are so small that bumps between them are, too. */
    private static final int MOST_TRIANGLES = 20_000;

    /** Cosine of a degree, the greatest angle of a triangle against the one that is hit. */
    private static final double LIKE_COSINE = 0.99984769515639124;

    /** Greatest distance of a triangle from the plane of the one that is hit. */
    private static final double LIKE_METRES = 0.02;

    private final PlacementSurfaces surfaces;
    private final Gun gun;
    private final RegionFit fit;
    private final double reach;

    GroundPlacement(PlacementSurfaces surfaces, Gun gun, RegionFit fit) {
        this.surfaces = surfaces;
        this.gun = gun;
        this.fit = fit;
        Aperture aperture = gun.aperture();
        reach = gun.slideMetres() + aperture.widthMetres() + aperture.heightMetres();
    }

    /** Returns the result of a shot that hits a terrain. */
    PlacementResult place(Shot shot, HeightField field) {
        GroundSeat aimed = seat(shot, field, shot.where());
        Fits place = null;
        Refusal reason = Refusal.NOT_FLAT;
        if (aimed.isEven()) {
            if (isFree(shot, field, aimed.portal())) {
                return new Fits(aimed.portal(), 0);
            }
            PlacementResult slid = slid(shot, field, aimed.portal());
            if (slid instanceof PlacementResult.Refused refused) {
                reason = refused.reason() == Refusal.TOO_SMALL ? Refusal.EDGE : refused.reason();
            } else {
                place = settled(shot, field, ((Fits) slid).portal());
            }
        }
        place = nearer(place, onFlat(shot, field));
        place = nearer(place, onCircles(shot, field, aimed.portal().frame(), place));
        if (place != null) {
            return place;
        }
        double uneven = reason == Refusal.NOT_FLAT ? aimed.measuredUneven(field) : 0;
        return new PlacementResult.Refused(reason, shot.where(), uneven);
    }

    private static Fits nearer(Fits a, Fits b) {
        return b == null || a != null && a.slideMetres() <= b.slideMetres() ? a : b;
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
        List<Vec3> sheet = planeOver(field, portal);
        if (sheet.size() < 3) {
            return null;
        }
        Aabb box = Aabb.of(sheet).grown(NEAR_PLANE_METRES);
        Ray inwards = Ray.of(portal.world(0, 0, BEFORE_METRES), portal.normal().negated());
        return region(inwards, List.of(SurfacePolygon.of(sheet, true)), box);
    }

    /**
     * Returns the corners of a square in the portal's plane without what is beside the terrain, counter-clockwise seen from
     * in front; less than three if nothing is left.
     */
    private List<Vec3> planeOver(HeightField field, Portal portal) {
        double r = reach;
        List<Vec3> corners =
                List.of(portal.world(-r, -r, 0), portal.world(r, -r, 0), portal.world(r, r, 0), portal.world(-r, r, 0));
        Vec3 east = new Vec3(1, 0, 0);
        Vec3 south = new Vec3(0, 0, 1);
        corners = cut(corners, east, field.x(field.cellColumns()));
        corners = cut(corners, east.negated(), -field.x(0));
        corners = cut(corners, south, field.z(field.cellRows()));
        return cut(corners, south.negated(), -field.z(0));
    }

    /** Keeps what is at most so far along a direction. */
    private static List<Vec3> cut(List<Vec3> corners, Vec3 direction, double most) {
        List<Vec3> left = new ArrayList<>();
        for (int i = 0; i < corners.size(); i++) {
            Vec3 a = corners.get(i);
            Vec3 b = corners.get((i + 1) % corners.size());
            double beyondA = direction.dot(a) - most;
            double beyondB = direction.dot(b) - most;
            if (beyondA <= 0) {
                left.add(a);
            }
            if (beyondA < 0 && beyondB > 0 || beyondA > 0 && beyondB < 0) {
                left.add(a.addScaled(beyondA / (beyondA - beyondB), b.minus(a)));
            }
        }
        return left;
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
    private Fits settled(Shot shot, HeightField field, Portal portal) {
        Fits place = over(shot, field, behind(field, portal));
        if (place != null) {
            return place;
        }
        Vec3 slide = portal.centre().minus(shot.where());
        Vec3 beyond = portal.centre().addScaled(CLEAR_METRES / slide.length(), slide);
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
    private Fits over(Shot shot, HeightField field, Vec3 on) {
        double metres =
                on == null ? Double.POSITIVE_INFINITY : on.minus(shot.where()).length();
        if (metres > gun.slideMetres()) {
            return null;
        }
        GroundSeat seat = seat(shot, field, on);
        return seat.isEven() && isFree(shot, field, seat.portal()) ? new Fits(seat.portal(), metres) : null;
    }

    /** Returns the place on ground that is as flat as a wall. */
    private Fits onFlat(Shot shot, HeightField field) {
        Aperture aperture = gun.aperture();
        Region region = flatRegion(shot, field, aperture.widthMetres() * aperture.heightMetres());
        if (region == null) {
            return null;
        }
        Vec3 where = Placement.onPlane(region.frame(), shot.ray(), shot.where());
        PlacementResult result = fit.fit(shot.id(), region, where, shot.upright(), shot.others());
        if (!(result instanceof Fits flat)) {
            return null;
        }
        Fits place = over(shot, field, behind(field, flat.portal()));
        return place != null ? place : flat;
    }

    /**
     * Returns the region of ground around the triangle that is hit, made of the triangles in reach, like those of a mesh;
     * {@code null} if the ground is not flat there.
     *
     * @param leastArea area of the aperture, square metres
     */
    private Region flatRegion(Shot shot, HeightField field, double leastArea) {
        int hit = surfaces.triangle(shot.hit().item());
        Aabb box = Aabb.around(shot.where(), new Vec3(2 * reach, 2 * reach, 2 * reach));
        List<Integer> triangles = new ArrayList<>();
        field.passing((bounds, at) -> triangles.size() <= MOST_TRIANGLES && box.overlaps(bounds, at), triangles::add);
        if (triangles.size() > MOST_TRIANGLES) {
            return null;
        }
        triangles.sort(null);
        Vec3 normal = field.normal(hit);
        Vec3 on = field.corner(hit, 0);
        boolean[] isLike = new boolean[triangles.size()];
        double area = 0;
        for (int i = 0; i < isLike.length; i++) {
            int triangle = triangles.get(i);
            isLike[i] = field.normal(triangle).dot(normal) >= LIKE_COSINE && isIn(field, triangle, on, normal);
            area += isLike[i] ? area(field, triangle) : 0;
        }
        if (area < leastArea) {
            return null;
        }
        List<SurfacePolygon> sheets = new ArrayList<>();
        for (int i = 0; i < isLike.length; i++) {
            int triangle = triangles.get(i);
            List<Vec3> corners =
                    List.of(field.corner(triangle, 0), field.corner(triangle, 1), field.corner(triangle, 2));
            sheets.add(SurfacePolygon.of(corners, isLike[i]));
        }
        return region(shot.ray(), sheets, box);
    }

    private static boolean isIn(HeightField field, int triangle, Vec3 on, Vec3 normal) {
        for (int corner = 0; corner < 3; corner++) {
            if (Math.abs(field.corner(triangle, corner).minus(on).dot(normal)) > LIKE_METRES) {
                return false;
            }
        }
        return true;
    }

    private static double area(HeightField field, int triangle) {
        Vec3 a = field.corner(triangle, 0);
        Vec3 b = field.corner(triangle, 1);
        Vec3 c = field.corner(triangle, 2);
        return b.minus(a).cross(c.minus(a)).length() / 2;
    }

    /**
     * Returns the region of ground that a ray hits, without what stands on it; {@code null} if it hits something else.
     *
     * @param box surfaces in it matter
     */
    private Region region(Ray ray, List<SurfacePolygon> ground, Aabb box) {
        List<Brush> solids = new ArrayList<>();
        List<SurfacePolygon> sheets = new ArrayList<>(ground);
        for (Blocker blocker : surfaces.near(box)) {
            if (blocker instanceof Blocker.Convex convex) {
                solids.add(convex.brush());
            } else if (blocker instanceof Blocker.Sheet sheet) {
                sheets.add(SurfacePolygon.of(sheet.shape().corners(), false));
            }
        }
        PlacementSurfaces local = PlacementSurfaces.of(solids, sheets);
        RayHit again = new RayHit();
        return local.first(ray, again) ? local.region(ray, again.item()) : null;
    }

    /** Returns the first free place on circles around the aimed point, if it is nearer than one that is known. */
    private Fits onCircles(Shot shot, HeightField field, Basis axes, Fits known) {
        for (int circle = 1; circle <= CIRCLES; circle++) {
            double radius = WIDEST * gun.slideMetres() * circle / CIRCLES;
            if (known != null && known.slideMetres() <= radius) {
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
                Fits found = isPossible ? over(shot, field, on) : null;
                if (found != null) {
                    return found;
                }
            }
        }
        return null;
    }
}
