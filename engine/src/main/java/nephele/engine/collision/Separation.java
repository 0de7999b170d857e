package nephele.engine.collision;

/** Signed distance between a moving shape and a collider, with the direction that increases it. Reused for every query. */
public final class Separation {
    private final Gjk gjk = new Gjk();
    private final SeparatingAxes axes = new SeparatingAxes();
    private Collider collider;
    private boolean overlapping;
    private double metres;
    private double normalX;
    private double normalY;
    private double normalZ;

    /** Negative when the shape reaches into the collider; never more than the truth. */
    public double metres() {
        return metres;
    }

    /** Unit length, from the collider towards the shape. */
    public double normalX() {
        return normalX;
    }

    public double normalY() {
        return normalY;
    }

    public double normalZ() {
        return normalZ;
    }

    /** Coordinate of the collider's nearest point along an axis; valid while the shape's core is outside. */
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

    /** The index of the face that holds the nearest point, or −1; of several the one that looks most upwards. */
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

    /** Measures a shape whose origin is at x, y, z in the world. */
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
