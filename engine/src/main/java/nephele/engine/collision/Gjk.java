package nephele.engine.collision;

/**
 * Distance between a moving shape's core and a collider: Gilbert, Johnson and Keerthi (1988), with the lower bound of
 * van den Bergen (1999), section 3. Every direction tried gives a plane that separates by v · w / |v|; the best of them
 * is the result, so that a search cut short underestimates the distance and never overestimates it. Reused for every
 * query.
 */
final class Gjk {
    private static final int MAX_ITERATIONS = 48;
    private static final double RELATIVE_GAP = 1e-15;

    private final GjkSimplex simplex = new GjkSimplex();
    private double distance;
    private double normalX;
    private double normalY;
    private double normalZ;

    /**
     * Returns the distance in metres between core and collider, never more than the true one; not positive when they
     * intersect.
     */
    double distance() {
        return distance;
    }

    /** Returns a component of the unit vector from the collider towards the shape; undefined when they intersect. */
    double normalX() {
        return normalX;
    }

    double normalY() {
        return normalY;
    }

    double normalZ() {
        return normalZ;
    }

    /** Returns one coordinate of the collider's nearest point, relative to the collider's centre. */
    double onCollider(SupportPoints collider, int axis) {
        return simplex.onCollider(collider, axis);
    }

    /**
     * Measures the distance.
     *
     * @param x coordinate of the shape's origin relative to the collider's centre; likewise y and z
     */
    void measure(RoundedHull shape, double x, double y, double z, SupportPoints collider) {
        simplex.clear();
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
            if (i > 0 && (square - along <= RELATIVE_GAP * square || simplex.holds(fromCore, fromVertex))) {
                return;
            }
            simplex.add(wX, wY, wZ, fromCore, fromVertex);
            if (simplex.reduce() || simplex.square() < 1e-26) {
                distance = 0;
                return;
            }
            if (simplex.square() >= square) {
                return;
            }
            square = simplex.square();
            vX = simplex.x();
            vY = simplex.y();
            vZ = simplex.z();
        }
    }

    private void keepBound(double vX, double vY, double vZ, double along) {
        double length = Math.sqrt(vX * vX + vY * vY + vZ * vZ);
        double bound = along / length;
        if (bound > distance) {
            distance = bound;
            normalX = vX / length;
            normalY = vY / length;
            normalZ = vZ / length;
        }
    }
}
