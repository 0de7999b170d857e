package nephele.engine.portal.placement;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.Brush;
import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.RayHit;
import nephele.engine.math.heightfield.HeightField;

/**
 * Finds the flat part of a terrain around a shot. The triangles near the shot are made into surfaces, like those of a
 * mesh; the other ones are too far away to matter.
 */
final class GroundRegion {
    /** With more triangles in reach, the cells are so small that bumps between them are, too. */
    private static final int MOST_TRIANGLES = 20_000;

    /** Cosine of a degree, the greatest angle of a triangle against the one that is hit. */
    private static final double LIKE_COSINE = 0.99984769515639124;

    /** Greatest distance of a triangle from the plane of the one that is hit. */
    private static final double LIKE_METRES = 0.02;

    private GroundRegion() {}

    /**
     * Returns the region around the triangle that a ray hits; {@code null} if the ground is not flat there.
     *
     * @param where the ray hits
     * @param reach greatest distance that matters, metres
     * @param leastArea area of the aperture, square metres
     * @param near the level's other surfaces
     */
    static Region of(
            HeightField field, int hit, Ray ray, Vec3 where, double reach, double leastArea, List<Blocker> near) {
        Aabb box = Aabb.around(where, new Vec3(2 * reach, 2 * reach, 2 * reach));
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
            sheets.add(new SurfacePolygon(corners, isLike[i]));
        }
        return grown(ray, sheets, near, box);
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
     * @param near surfaces of which those in the box matter
     */
    static Region grown(Ray ray, List<SurfacePolygon> ground, List<Blocker> near, Aabb box) {
        List<Brush> solids = new ArrayList<>();
        List<SurfacePolygon> sheets = new ArrayList<>(ground);
        for (Blocker blocker : near) {
            if (!blocker.bounds().overlaps(box)) {
                continue;
            }
            if (blocker instanceof Blocker.Convex convex) {
                solids.add(convex.brush());
            } else if (blocker instanceof Blocker.Sheet sheet) {
                sheets.add(new SurfacePolygon(sheet.shape().corners(), false));
            }
        }
        PlacementSurfaces local = PlacementSurfaces.of(solids, sheets);
        RayHit again = new RayHit();
        return local.first(ray, again) ? local.region(ray, again.item()) : null;
    }
}
