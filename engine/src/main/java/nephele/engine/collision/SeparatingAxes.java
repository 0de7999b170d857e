package nephele.engine.collision;

import org.joml.Vector3d;
import org.joml.Vector3dc;

/**
 * The separating axis test between a shape's core and a collider (Gottschalk, Lin and Manocha 1996): the distance and
 * axis by which the core has to move to touch the collider from outside. Exact for points, segments and boxes. Axes of
 * nearly zero length are skipped: parallel edges add no axis that the faces do not give.
 */
final class SeparatingAxes {
    private static final double PARALLEL_SINE = 1e-10;

    private RoundedHull shape;
    private Collider collider;
    private double x;
    private double y;
    private double z;
    private double distance;
    private final Vector3d normal = new Vector3d();

    /** Returns the greatest separation over all axes; negative: depth of the core in the collider. */
    double distance() {
        return distance;
    }

    /** Returns that separation's unit axis, from the collider towards the core. */
    Vector3dc normal() {
        return normal;
    }

    /**
     * Measures the separation.
     *
     * @param localX coordinate of the shape's origin relative to the collider's centre; likewise y and z
     */
    void measure(RoundedHull of, double localX, double localY, double localZ, Collider against) {
        shape = of;
        collider = against;
        x = localX;
        y = localY;
        z = localZ;
        distance = Double.NEGATIVE_INFINITY;
        for (int face = 0; face < collider.faces(); face++) {
            axis(collider.plane(face, 0), collider.plane(face, 1), collider.plane(face, 2));
        }
        // In the order of RoundedHull.box, the points 1, 2 and 4 end the three edges that start at point 0.
        for (int end = 1; end < shape.corePoints(); end *= 2) {
            crossAxes(
                    shape.core(end, 0) - shape.core(0, 0),
                    shape.core(end, 1) - shape.core(0, 1),
                    shape.core(end, 2) - shape.core(0, 2));
        }
        if (shape.corePoints() == 8) {
            boxFaces(1, 2);
            boxFaces(2, 4);
            boxFaces(4, 1);
        }
        if (distance == Double.NEGATIVE_INFINITY) {
            // A point in a point, or coincident parallel segments: every direction of separation is equally long.
            axis(0, 1, 0);
        }
    }

    private void boxFaces(int a, int b) {
        double aX = shape.core(a, 0) - shape.core(0, 0);
        double aY = shape.core(a, 1) - shape.core(0, 1);
        double aZ = shape.core(a, 2) - shape.core(0, 2);
        double bX = shape.core(b, 0) - shape.core(0, 0);
        double bY = shape.core(b, 1) - shape.core(0, 1);
        double bZ = shape.core(b, 2) - shape.core(0, 2);
        bothWays(aY * bZ - aZ * bY, aZ * bX - aX * bZ, aX * bY - aY * bX, 0);
    }

    private void crossAxes(double sX, double sY, double sZ) {
        double s2 = sX * sX + sY * sY + sZ * sZ;
        for (int i = 0; i < collider.edges(); i++) {
            double eX = collider.edge(i, 0);
            double eY = collider.edge(i, 1);
            double eZ = collider.edge(i, 2);
            double smallest = PARALLEL_SINE * PARALLEL_SINE * s2 * (eX * eX + eY * eY + eZ * eZ);
            bothWays(eY * sZ - eZ * sY, eZ * sX - eX * sZ, eX * sY - eY * sX, smallest);
        }
    }

    private void bothWays(double nX, double nY, double nZ, double smallestSquare) {
        double square = nX * nX + nY * nY + nZ * nZ;
        if (square > smallestSquare) {
            double length = Math.sqrt(square);
            axis(nX / length, nY / length, nZ / length);
            axis(-nX / length, -nY / length, -nZ / length);
        }
    }

    private void axis(double nX, double nY, double nZ) {
        int core = shape.least(nX, nY, nZ);
        int vertex = collider.farthest(nX, nY, nZ);
        double separation = nX * (shape.core(core, 0) + x - collider.vertex(vertex, 0))
                + nY * (shape.core(core, 1) + y - collider.vertex(vertex, 1))
                + nZ * (shape.core(core, 2) + z - collider.vertex(vertex, 2));
        if (separation > distance) {
            distance = separation;
            normal.set(nX, nY, nZ);
        }
    }
}
