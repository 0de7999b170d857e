package nephele.engine.collision;

import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * Distance between a moving shape's core and a collider: Gilbert, Johnson and Keerthi (1988), with the lower bound of
 * van den Bergen (1999), section 3. Every direction tried gives a plane that separates by v · w / |v|; the best of them
 * is the result, so that a search cut short underestimates the distance and never overestimates it. Reused for every
 * query.
 *
 * <p>The simplex is one to four points of the Minkowski difference, reduced to those that the point of their convex hull
 * nearest to the origin needs. Voronoi regions after Ericson, Real-Time Collision Detection (2005), sections 5.1.2, 5.1.5
 * and 9.5.
 */
final class Gjk {
    private static final int MAX_ITERATIONS = 48;
    private static final double RELATIVE_GAP = 1e-15;

    private final Vector3d normal = new Vector3d();
    private double distance;
    /** The simplex: three numbers for each point of the Minkowski difference, and the two points that it comes from. */
    private final double[] p = new double[12];

    private final int[] corePoint = new int[4];
    private final int[] vertex = new int[4];
    private int size;
    /** The simplex points that the point nearest to the origin needs, and their weights in it. */
    private final int[] keep = new int[3];

    private final double[] weight = new double[3];
    private int kept;
    private double nearestX;
    private double nearestY;
    private double nearestZ;
    private double nearestSquare;

    /**
     * Returns the distance in metres between core and collider, never more than the true one; not positive when they
     * intersect.
     */
    double distance() {
        return distance;
    }

    /** Returns the unit vector from the collider towards the shape; undefined when they intersect. */
    Vector3dc normal() {
        return normal;
    }

    /** Returns one coordinate of the collider's nearest point, relative to the collider's centre. */
    double onCollider(SupportPoints collider, int axis) {
        double sum = 0;
        for (int i = 0; i < size; i++) {
            sum += weight[i] * collider.vertex(vertex[i], axis);
        }
        return sum;
    }

    /**
     * Measures the distance.
     *
     * @param x coordinate of the shape's origin relative to the collider's centre; likewise y and z
     */
    void measure(RoundedHull shape, double x, double y, double z, SupportPoints collider) {
        size = 0;
        distance = Double.NEGATIVE_INFINITY;
        boolean startsCentred = x == 0 && y == 0 && z == 0;
        double vX = x;
        double vY = startsCentred ? 1 : y;
        double vZ = z;
        double square = Double.POSITIVE_INFINITY;
        for (int i = 0; i < MAX_ITERATIONS; i++) {
            int fromCore = shape.least(vX, vY, vZ);
            int fromVertex = collider.farthest(vX, vY, vZ);
            double wX = shape.core(fromCore, 0) + x - collider.vertex(fromVertex, 0);
            double wY = shape.core(fromCore, 1) + y - collider.vertex(fromVertex, 1);
            double wZ = shape.core(fromCore, 2) + z - collider.vertex(fromVertex, 2);
            double along = vX * wX + vY * wY + vZ * wZ;
            keepBound(vX, vY, vZ, along);
            if (i > 0 && (square - along <= RELATIVE_GAP * square || holds(fromCore, fromVertex))) {
                return;
            }
            add(wX, wY, wZ, fromCore, fromVertex);
            if (reduce() || nearestSquare < 1e-26) {
                distance = 0;
                return;
            }
            if (nearestSquare >= square) {
                return;
            }
            square = nearestSquare;
            vX = nearestX;
            vY = nearestY;
            vZ = nearestZ;
        }
    }

    private void keepBound(double vX, double vY, double vZ, double along) {
        double length = Math.sqrt(vX * vX + vY * vY + vZ * vZ);
        double bound = along / length;
        if (bound > distance) {
            distance = bound;
            normal.set(vX / length, vY / length, vZ / length);
        }
    }

    private void add(double x, double y, double z, int fromCore, int fromVertex) {
        p[3 * size] = x;
        p[3 * size + 1] = y;
        p[3 * size + 2] = z;
        corePoint[size] = fromCore;
        vertex[size] = fromVertex;
        size++;
    }

    private boolean holds(int fromCore, int fromVertex) {
        for (int i = 0; i < size; i++) {
            if (corePoint[i] == fromCore && vertex[i] == fromVertex) {
                return true;
            }
        }
        return false;
    }

    /** Finds the nearest point and drops the points that it does not need; returns true if the origin is inside. */
    private boolean reduce() {
        nearestSquare = Double.POSITIVE_INFINITY;
        switch (size) {
            case 1 -> corner(0);
            case 2 -> edge(0, 1);
            case 3 -> triangle(0, 1, 2);
            default -> {
                if (tetrahedronHoldsOrigin()) {
                    return true;
                }
            }
        }
        dropUnused();
        return false;
    }

    private void dropUnused() {
        for (int i = 0; i < kept; i++) {
            int from = keep[i];
            // keep[] ascends, so nothing still needed is overwritten.
            p[3 * i] = p[3 * from];
            p[3 * i + 1] = p[3 * from + 1];
            p[3 * i + 2] = p[3 * from + 2];
            corePoint[i] = corePoint[from];
            vertex[i] = vertex[from];
        }
        size = kept;
    }

    private boolean tetrahedronHoldsOrigin() {
        boolean outside = face(0, 1, 2, 3);
        outside |= face(0, 1, 3, 2);
        outside |= face(0, 2, 3, 1);
        outside |= face(1, 2, 3, 0);
        return !outside;
    }

    /**
     * Tests a face unless the origin is strictly on the side of {@code opposite}; returns true if the face was tested.
     * A flat tetrahedron has no such side.
     */
    private boolean face(int a, int b, int c, int opposite) {
        double abX = p[3 * b] - p[3 * a];
        double abY = p[3 * b + 1] - p[3 * a + 1];
        double abZ = p[3 * b + 2] - p[3 * a + 2];
        double acX = p[3 * c] - p[3 * a];
        double acY = p[3 * c + 1] - p[3 * a + 1];
        double acZ = p[3 * c + 2] - p[3 * a + 2];
        double nX = abY * acZ - abZ * acY;
        double nY = abZ * acX - abX * acZ;
        double nZ = abX * acY - abY * acX;
        double adX = p[3 * opposite] - p[3 * a];
        double adY = p[3 * opposite + 1] - p[3 * a + 1];
        double adZ = p[3 * opposite + 2] - p[3 * a + 2];
        double opposing = adX * nX + adY * nY + adZ * nZ;
        double origin = -(p[3 * a] * nX + p[3 * a + 1] * nY + p[3 * a + 2] * nZ);
        double flat = 1e-13 * Math.sqrt((nX * nX + nY * nY + nZ * nZ) * (adX * adX + adY * adY + adZ * adZ));
        if (Math.abs(opposing) > flat && origin * opposing > 0) {
            return false;
        }
        triangle(a, b, c);
        return true;
    }

    private void corner(int a) {
        if (offer(p[3 * a], p[3 * a + 1], p[3 * a + 2])) {
            kept = 1;
            keep[0] = a;
            weight[0] = 1;
        }
    }

    private void edge(int a, int b) {
        double dX = p[3 * b] - p[3 * a];
        double dY = p[3 * b + 1] - p[3 * a + 1];
        double dZ = p[3 * b + 2] - p[3 * a + 2];
        double t = -(p[3 * a] * dX + p[3 * a + 1] * dY + p[3 * a + 2] * dZ) / (dX * dX + dY * dY + dZ * dZ);
        // The negated comparison sends a zero-length edge (t is NaN) to its first corner.
        if (!(t > 0)) {
            corner(a);
        } else if (t >= 1) {
            corner(b);
        } else if (offer(p[3 * a] + t * dX, p[3 * a + 1] + t * dY, p[3 * a + 2] + t * dZ)) {
            kept = 2;
            keep[0] = a;
            keep[1] = b;
            weight[0] = 1 - t;
            weight[1] = t;
        }
    }

    private void triangle(int a, int b, int c) {
        double abX = p[3 * b] - p[3 * a];
        double abY = p[3 * b + 1] - p[3 * a + 1];
        double abZ = p[3 * b + 2] - p[3 * a + 2];
        double acX = p[3 * c] - p[3 * a];
        double acY = p[3 * c + 1] - p[3 * a + 1];
        double acZ = p[3 * c + 2] - p[3 * a + 2];
        double d1 = -dot(abX, abY, abZ, a);
        double d2 = -dot(acX, acY, acZ, a);
        double d3 = -dot(abX, abY, abZ, b);
        double d4 = -dot(acX, acY, acZ, b);
        double d5 = -dot(abX, abY, abZ, c);
        double d6 = -dot(acX, acY, acZ, c);
        double areaA = d3 * d6 - d5 * d4;
        double areaB = d5 * d2 - d1 * d6;
        double areaC = d1 * d4 - d3 * d2;
        double sum = areaA + areaB + areaC;
        if (!(areaA > 0 && areaB > 0 && areaC > 0 && sum > 0)) {
            edge(a, b);
            edge(a, c);
            edge(b, c);
            return;
        }
        double nX = abY * acZ - abZ * acY;
        double nY = abZ * acX - abX * acZ;
        double nZ = abX * acY - abY * acX;
        // Projects on the plane: the weighted sum of far corners would cancel.
        double scale = dot(nX, nY, nZ, a) / (nX * nX + nY * nY + nZ * nZ);
        if (offer(nX * scale, nY * scale, nZ * scale)) {
            keepThree(a, b, c);
            weight[0] = areaA / sum;
            weight[1] = areaB / sum;
            weight[2] = areaC / sum;
        }
    }

    private void keepThree(int a, int b, int c) {
        kept = 3;
        keep[0] = a;
        keep[1] = b;
        keep[2] = c;
    }

    private double dot(double x, double y, double z, int i) {
        return x * p[3 * i] + y * p[3 * i + 1] + z * p[3 * i + 2];
    }

    private boolean offer(double x, double y, double z) {
        double square = x * x + y * y + z * z;
        if (!(square < nearestSquare)) {
            return false;
        }
        nearestSquare = square;
        nearestX = x;
        nearestY = y;
        nearestZ = z;
        return true;
    }

    /** Points relative to an origin, which stand for their convex hull. */
    interface SupportPoints {
        /** Returns the index of the point farthest along a direction. */
        int farthest(double x, double y, double z);

        /** Returns one coordinate of a point, relative to the origin. */
        double vertex(int point, int axis);
    }
}
