package nephele.engine.collision.rigid.contact;

import nephele.engine.collision.rigid.body.Poses;

/** The edge of a box farthest along a normal, and the adjacent parallel edge that is next farthest. Reused. */
final class BoxEdge {
    private final double[] axis = new double[3];
    private final double[] nearest = new double[3];
    private final double[] next = new double[3];
    private int nearestSide;
    private int nextSide;

    /** Distance in metres by which the other edge is farther back along the normal. */
    double rise;

    /**
     * Finds both edges.
     *
     * @param sign 1 if the manifold's normal points out of the box, −1 if into it
     */
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

    /** Returns the middle of the nearest or the other edge, relative to the box's centre. */
    double middle(boolean other, int component) {
        return other ? next[component] : nearest[component];
    }

    /** Returns the number, 0 to 3, of the edge among the four parallel ones. */
    int side(boolean other) {
        return other ? nextSide : nearestSide;
    }
}
