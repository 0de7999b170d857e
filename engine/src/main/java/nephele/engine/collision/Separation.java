package nephele.engine.collision;

/**
 * Signed distance between a moving shape and a collider, with the direction that increases it. Reused for every query.
 */
public final class Separation {
    private final Gjk gjk = new Gjk();
    private final SeparatingAxes axes = new SeparatingAxes();
    private Collider collider;
    private boolean overlapping;
    private double metres;
    private double normalX;
    private double normalY;
    private double normalZ;

    /** Returns the signed distance, negative when the shape overlaps the collider; never more than the true one. */
    public double metres() {
        return metres;
    }

    /** Returns a component of the unit vector from the collider towards the shape. */
    public double normalX() {
        return normalX;
    }

    /** Returns the y component of that vector. */
    public double normalY() {
        return normalY;
    }

    /** Returns the z component of that vector. */
    public double normalZ() {
        return normalZ;
    }

    /**
     * Returns a world coordinate of the collider's nearest point along an axis (0, 1, 2); valid while the shape's core
     * is outside.
     */
    public double onCollider(int axis) {
        double centre =
                switch (axis) {
                    case 0 -> collider.centre().x();
                    case 1 -> collider.centre().y();
                    default -> collider.centre().z();
                };
        return centre + (overlapping ? 0 : gjk.onCollider(collider, axis) + collider.radiusMetres() * normal(axis));
    }

    private double normal(int axis) {
        return axis == 0 ? normalX : axis == 1 ? normalY : normalZ;
    }

    /**
     * Returns the face that contains the nearest point, of several the one with the most upward normal; −1 for none.
     */
    int upmostFace(double toleranceMetres) {
        if (overlapping) {
            return -1;
        }
        double x = gjk.onCollider(collider, 0);
        double y = gjk.onCollider(collider, 1);
        double z = gjk.onCollider(collider, 2);
        int best = -1;
        for (int face = 0; face < collider.faces(); face++) {
            if (Math.abs(collider.inFrontOf(face, x, y, z)) <= toleranceMetres
                    && (best < 0 || collider.plane(face, 1) > collider.plane(best, 1))) {
                best = face;
            }
        }
        return best;
    }

    /** Measures a shape with its origin at x, y, z in the world. */
    public void measure(RoundedHull shape, double x, double y, double z, Collider against) {
        collider = against;
        double localX = x - against.centre().x();
        double localY = y - against.centre().y();
        double localZ = z - against.centre().z();
        gjk.measure(shape, localX, localY, localZ, against);
        overlapping = !(gjk.distance() > 0);
        if (overlapping) {
            axes.measure(shape, localX, localY, localZ, against);
            keep(axes.distance(), axes.normalX(), axes.normalY(), axes.normalZ());
        } else {
            keep(gjk.distance(), gjk.normalX(), gjk.normalY(), gjk.normalZ());
        }
        metres -= shape.radiusMetres() + against.radiusMetres();
    }

    private void keep(double distance, double nX, double nY, double nZ) {
        metres = distance;
        normalX = nX;
        normalY = nY;
        normalZ = nZ;
    }
}
