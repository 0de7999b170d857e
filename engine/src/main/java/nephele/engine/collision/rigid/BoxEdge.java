package nephele.engine.collision.rigid;

/** The edge of a box that lies farthest along a normal, and the parallel one beside it that lies next. Reused. */
final class BoxEdge {
    private final double[] axis = new double[3];
    private final double[] nearest = new double[3];
    private final double[] next = new double[3];
    private int nearestSide;
    private int nextSide;

    /** How much farther back along the normal the other edge lies, metres. */
    double rise;

    /** @param sign of the manifold's normal, as it looks from the box outwards */
    void take(Poses poses, int box, int ofAxis, Manifold manifold, double sign) {
        double[] x = poses.axes;
        double least = Double.POSITIVE_INFINITY;
        int flipped = 0;
        nearestSide = 0;
        for (int c = 0; c < 3; c++) {
            axis[c] = x[9 * box + 3 * ofAxis + c];
            nearest[c] = 0;
        }
        for (int k = 1; k < 3; k++) {
            int at = 9 * box + 3 * ((ofAxis + k) % 3);
            double h = poses.half[3 * box + (ofAxis + k) % 3];
            double dot = sign * (x[at] * manifold.nX + x[at + 1] * manifold.nY + x[at + 2] * manifold.nZ);
            double side = dot < 0 ? -h : h;
            nearestSide += dot < 0 ? 0 : k;
            for (int c = 0; c < 3; c++) {
                nearest[c] += side * x[at + c];
            }
            if (2 * h * Math.abs(dot) < least) {
                least = 2 * h * Math.abs(dot);
                flipped = dot < 0 ? k : -k;
                for (int c = 0; c < 3; c++) {
                    next[c] = -2 * side * x[at + c];
                }
            }
        }
        rise = least;
        nextSide = nearestSide + flipped;
        for (int c = 0; c < 3; c++) {
            next[c] += nearest[c];
        }
    }

    double along(int component) {
        return axis[component];
    }

    /** The middle of the nearest edge or of the other one, from the box's centre. */
    double middle(boolean other, int component) {
        return other ? next[component] : nearest[component];
    }

    /** 0 to 3: which of the four parallel edges this is. */
    int side(boolean other) {
        return other ? nextSide : nearestSide;
    }
}
