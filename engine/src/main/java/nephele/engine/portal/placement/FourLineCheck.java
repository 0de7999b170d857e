package nephele.engine.portal.placement;

import java.util.Map;
import java.util.TreeMap;
import nephele.engine.math.Directions;
import nephele.engine.math.TriangleSoup;
import nephele.engine.math.Vec3;

/**
 * The test of the student report on renderable portals: four lines from the centre of the portal's rectangle to its
 * corners, each followed over adjacent triangles as long as these are coplanar with the first; the portal fits if all
 * four end inside. It misses obstacles between the lines and cannot cross T-junctions. An approximation kept to measure
 * it against {@link Placement}.
 */
public final class FourLineCheck {
    private final TriangleSoup soup;
    /** For each side of each triangle the adjacent triangle; −1 for none. */
    private final int[] beyond;

    /** Finds the neighbours of all triangles of a surface. */
    public FourLineCheck(TriangleSoup soup) {
        this.soup = soup;
        beyond = neighbours(soup);
    }

    /** Finds for each side the triangle that has it in opposite order. */
    private static int[] neighbours(TriangleSoup soup) {
        int[] vertices = soup.vertices();
        Map<Long, Integer> sides = new TreeMap<>();
        for (int side = 0; side < vertices.length; side++) {
            sides.put(ends(vertices[side], vertices[next(side)]), side);
        }
        int[] beyond = new int[vertices.length];
        for (int side = 0; side < vertices.length; side++) {
            Integer opposite = sides.get(ends(vertices[next(side)], vertices[side]));
            beyond[side] = opposite == null ? -1 : opposite / 3;
        }
        return beyond;
    }

    private static long ends(int from, int to) {
        return (long) from << 32 | to;
    }

    /** Returns the next side of the same triangle, which starts where a side ends. */
    private static int next(int side) {
        return side - side % 3 + (side + 1) % 3;
    }

    /**
     * Returns true if the rectangle fits.
     *
     * @param triangle the triangle that contains the centre
     * @param right half of the rectangle's width along its bottom
     * @param up half of its height along its sides
     */
    public boolean fits(int triangle, Vec3 centre, Vec3 right, Vec3 up) {
        return walk(triangle, centre, sum(centre, right, 1, up, 1))
                && walk(triangle, centre, sum(centre, right, -1, up, 1))
                && walk(triangle, centre, sum(centre, right, -1, up, -1))
                && walk(triangle, centre, sum(centre, right, 1, up, -1));
    }

    private static Vec3 sum(Vec3 o, Vec3 a, double ofA, Vec3 b, double ofB) {
        return o.addScaled(ofA, a).addScaled(ofB, b);
    }

    private boolean walk(int start, Vec3 from, Vec3 to) {
        Vec3 normal = normal(start);
        Vec3 displacement = to.minus(from);
        int current = start;
        for (int steps = 0; steps < soup.triangleCount(); steps++) {
            int exit = exit(current, normal, from, displacement);
            if (exit < 0) {
                return true;
            }
            current = beyond[exit];
            if (current < 0 || normal.dot(normal(current)) < Tolerance.COPLANAR_COSINE) {
                return false;
            }
        }
        return false;
    }

    /** Returns the side through which the line leaves a triangle, −1 if it ends inside. */
    private int exit(int triangle, Vec3 normal, Vec3 from, Vec3 displacement) {
        int exit = -1;
        double earliest = 1;
        for (int side = 3 * triangle; side < 3 * triangle + 3; side++) {
            Vec3 a = corner(side);
            Vec3 out = corner(3 * triangle + (side + 1) % 3).minus(a).cross(normal);
            double rate = out.dot(displacement);
            double at = out.dot(a.minus(from)) / rate;
            if (rate > 0 && at < earliest) {
                earliest = at;
                exit = side;
            }
        }
        return exit;
    }

    private Vec3 normal(int triangle) {
        Vec3 a = corner(3 * triangle);
        Vec3 n =
                corner(3 * triangle + 1).minus(a).cross(corner(3 * triangle + 2).minus(a));
        return Directions.unit(n);
    }

    private Vec3 corner(int at) {
        int vertex = 3 * soup.vertices()[at];
        return new Vec3(soup.positions()[vertex], soup.positions()[vertex + 1], soup.positions()[vertex + 2]);
    }
}
