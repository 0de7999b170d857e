package nephele.engine.portal.placement;

import java.util.Arrays;
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

    /** Finds pairs of sides with the same ends in opposite order. */
    private static int[] neighbours(TriangleSoup soup) {
        int sides = soup.vertices().length;
        int[] beyond = new int[sides];
        Arrays.fill(beyond, -1);
        Side[] sorted = new Side[sides];
        for (int side = 0; side < sides; side++) {
            int from = soup.vertices()[side];
            int to = soup.vertices()[side - side % 3 + (side + 1) % 3];
            sorted[side] = new Side(side, (long) Math.min(from, to) << 32 | Math.max(from, to), from < to);
        }
        Arrays.sort(sorted, (a, b) -> Long.compare(a.ends(), b.ends()));
        for (int i = 0; i + 1 < sides; i++) {
            Side a = sorted[i];
            Side b = sorted[i + 1];
            if (a.ends() == b.ends() && a.forward() != b.forward()) {
                beyond[a.number()] = b.number() / 3;
                beyond[b.number()] = a.number() / 3;
            }
        }
        return beyond;
    }

    private record Side(int number, long ends, boolean forward) {}

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
