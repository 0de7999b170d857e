package nephele.engine.level.layout;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;

/** Convex polygons in space, cut by planes (Sutherland and Hodgman 1974). */
public final class FacePieces {
    private FacePieces() {}

    /** Returns the part of a polygon behind a plane; empty if there is none. */
    public static List<Vec3> behind(List<Vec3> polygon, Plane plane) {
        List<Vec3> kept = new ArrayList<>();
        for (int i = 0; i < polygon.size(); i++) {
            Vec3 p = polygon.get(i);
            Vec3 q = polygon.get((i + 1) % polygon.size());
            double frontP = plane.signedDistance(p);
            double frontQ = plane.signedDistance(q);
            if (frontP <= 0) {
                kept.add(p);
            }
            if (frontP < 0 && frontQ > 0 || frontP > 0 && frontQ < 0) {
                kept.add(p.lerp(q, frontP / (frontP - frontQ)));
            }
        }
        return kept;
    }

    /** Returns the part of a polygon that lies over another one in the same plane. */
    public static List<Vec3> common(List<Vec3> polygon, List<Vec3> other, Vec3 normal) {
        List<Vec3> kept = polygon;
        for (int i = 0; i < other.size() && kept.size() >= 3; i++) {
            Vec3 from = other.get(i);
            Vec3 side = other.get((i + 1) % other.size()).minus(from);
            double length = side.length();
            if (length > 0) {
                kept = behind(kept, Plane.through(side.cross(normal).scaled(1 / length), from));
            }
        }
        return kept;
    }

    /** Returns the parts of polygons outside a solid. */
    public static List<List<Vec3>> outside(List<List<Vec3>> polygons, ConvexPolyhedron solid) {
        List<List<Vec3>> kept = new ArrayList<>();
        for (List<Vec3> polygon : polygons) {
            List<Vec3> rest = polygon;
            for (ConvexPolyhedron.Face face : solid.faces()) {
                keep(behind(rest, face.plane().opposite()), kept);
                rest = behind(rest, face.plane());
            }
        }
        return kept;
    }

    private static void keep(List<Vec3> part, List<List<Vec3>> kept) {
        if (areaSquareMetres(part) > 0) {
            kept.add(part);
        }
    }

    /** Returns the area of a flat polygon. */
    public static double areaSquareMetres(List<Vec3> polygon) {
        Vec3 doubled = Vec3.ZERO;
        for (int i = 2; i < polygon.size(); i++) {
            Vec3 first = polygon.get(i - 1).minus(polygon.get(0));
            doubled = doubled.plus(first.cross(polygon.get(i).minus(polygon.get(0))));
        }
        return doubled.length() / 2;
    }

    /** Returns the area of a flat polygon over its longest edge: the width of a rectangle, 0 for no area. */
    public static double widthMetres(List<Vec3> polygon) {
        double longest = 0;
        for (int i = 0; i < polygon.size(); i++) {
            Vec3 next = polygon.get((i + 1) % polygon.size());
            longest = Math.max(longest, next.minus(polygon.get(i)).length());
        }
        return longest > 0 ? areaSquareMetres(polygon) / longest : 0;
    }
}
