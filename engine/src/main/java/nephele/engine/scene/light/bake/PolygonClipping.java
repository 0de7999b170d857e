package nephele.engine.scene.light.bake;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;

/** Clipping of convex polygons in space. */
public final class PolygonClipping {
    /** Corners this near to a plane count as on it. */
    private static final double ON_PLANE_METRES = 1e-6;

    private PolygonClipping() {}

    /** Returns the part behind the plane; empty if nothing with an area is left. */
    static List<Vec3> behind(List<Vec3> polygon, Plane plane) {
        return keep(polygon, plane, 1);
    }

    static List<Vec3> before(List<Vec3> polygon, Plane plane) {
        return keep(polygon, plane, -1);
    }

    /** Clips at one plane (Sutherland and Hodgman 1974). */
    private static List<Vec3> keep(List<Vec3> polygon, Plane plane, double sign) {
        List<Vec3> kept = new ArrayList<>(polygon.size() + 1);
        boolean hasInside = false;
        for (int i = 0; i < polygon.size(); i++) {
            Vec3 a = polygon.get(i);
            Vec3 b = polygon.get((i + 1) % polygon.size());
            double da = sign * plane.signedDistance(a);
            double db = sign * plane.signedDistance(b);
            hasInside |= da < -ON_PLANE_METRES;
            if (da <= ON_PLANE_METRES) {
                kept.add(a);
            }
            if (Math.abs(da) > ON_PLANE_METRES && Math.abs(db) > ON_PLANE_METRES && da < 0 != db < 0) {
                kept.add(a.lerp(b, da / (da - db)));
            }
        }
        return hasInside && kept.size() >= 3 ? kept : List.of();
    }

    static double area(List<Vec3> polygon) {
        Vector3d sum = new Vector3d();
        Vector3d first = polygon.isEmpty() ? sum : polygon.get(0).toVector();
        for (int i = 2; i < polygon.size(); i++) {
            Vector3d a = polygon.get(i - 1).toVector().sub(first);
            sum.add(a.cross(polygon.get(i).toVector().sub(first)));
        }
        return sum.length() / 2;
    }

    public static Vec3 centroid(List<Vec3> polygon) {
        Vector3d sum = new Vector3d();
        for (Vec3 p : polygon) {
            sum.add(p.toVector());
        }
        sum.div(polygon.size());
        return new Vec3(sum.x, sum.y, sum.z);
    }
}
