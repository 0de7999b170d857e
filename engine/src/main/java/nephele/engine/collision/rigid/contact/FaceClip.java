package nephele.engine.collision.rigid.contact;

/**
 * Clips one face against the sides of another (Sutherland and Hodgman 1974) and keeps up to four points of the rest
 * near the other's plane. Points are relative to one origin that the caller chooses. Reused.
 */
final class FaceClip {
    /**
     * Squared sine of the angle between edges below which they are parallel: they add no axis that the faces do not
     * give.
     */
    static final double PARALLEL_SINE_SQUARED = 1e-6;

    private static final int CAPACITY = 160;

    private static final double EDGE_METRES = 1e-3;

    /** Fraction of half the thickness of the thinner shape. */
    private static final double EDGE_FRACTION = 0.6;

    private double[] p = new double[3 * CAPACITY];
    private double[] spare = new double[3 * CAPACITY];
    private int[] id = new int[CAPACITY];
    private int[] spareId = new int[CAPACITY];
    private final double[] depth = new double[CAPACITY];
    private int count;
    private double tolerance;
    private boolean sliver;

    /**
     * Returns the margin in metres by which the edge axis must separate better than the faces to become an edge
     * contact. A body across a thin shape gets all corners of the crossing as contact points; with only the deepest
     * edge, a different one each tick, it would rock for ever.
     */
    static double edgeMargin(double leastHalfMetres) {
        return Math.min(EDGE_METRES, EDGE_FRACTION * leastHalfMetres);
    }

    /** Returns the distance in metres below which features of shapes count as flush, so that the choice of one is steady. */
    static double tolerance(double leastHalfMetres) {
        return Math.min(1e-3, 0.02 * leastHalfMetres);
    }

    /**
     * Begins a face.
     *
     * @param metres by which a corner may be outside and still count as inside: keeps features of flush faces steady
     */
    void start(double metres) {
        tolerance = metres;
        count = 0;
        sliver = false;
    }

    void corner(double x, double y, double z, int feature) {
        p[3 * count] = x;
        p[3 * count + 1] = y;
        p[3 * count + 2] = z;
        id[count++] = feature;
    }

    /** Removes the part in front of a plane. */
    void side(double nX, double nY, double nZ, double distance, int number) {
        double most = Double.NEGATIVE_INFINITY;
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < count; i++) {
            depth[i] = nX * p[3 * i] + nY * p[3 * i + 1] + nZ * p[3 * i + 2] - distance;
            most = Math.max(most, depth[i]);
            least = Math.min(least, depth[i]);
        }
        if (most <= tolerance) {
            return;
        }
        // A face that reaches behind this side by almost nothing is beside the other face, not in front of it.
        sliver |= least > -2 * tolerance;
        cut(number);
    }

    private void cut(int number) {
        int kept = 0;
        for (int i = 0; i < count; i++) {
            int j = i + 1 == count ? 0 : i + 1;
            if (depth[i] <= 0) {
                copy(i, kept++);
            }
            if ((depth[i] < 0 && depth[j] > 0) || (depth[i] > 0 && depth[j] < 0)) {
                double t = depth[i] / (depth[i] - depth[j]);
                for (int axis = 0; axis < 3; axis++) {
                    spare[3 * kept + axis] = p[3 * i + axis] + t * (p[3 * j + axis] - p[3 * i + axis]);
                }
                spareId[kept++] = 16 + 7 * Math.min(id[i], id[j]) + 3 * Math.max(id[i], id[j]) + 29 * number;
            }
        }
        double[] p2 = p;
        p = spare;
        spare = p2;
        int[] id2 = id;
        id = spareId;
        spareId = id2;
        count = kept;
    }

    private void copy(int from, int to) {
        spare[3 * to] = p[3 * from];
        spare[3 * to + 1] = p[3 * from + 1];
        spare[3 * to + 2] = p[3 * from + 2];
        spareId[to] = id[from];
    }

    /** Returns true when the faces are beside rather than in front of each other. */
    boolean isSliver() {
        return sliver || count == 0;
    }

    /**
     * Adds to {@code out} up to four points that are nearer to a plane than {@code reach}: the deepest, the farthest
     * from it and the two that span most area to either side (Gregorius 2013, GDC "The separating axis test").
     */
    void keep(double nX, double nY, double nZ, double distance, double reach, Manifold out) {
        int near = 0;
        for (int i = 0; i < count; i++) {
            double metres = nX * p[3 * i] + nY * p[3 * i + 1] + nZ * p[3 * i + 2] - distance;
            if (metres <= reach) {
                copyWithin(i, near);
                depth[near++] = metres;
            }
        }
        count = near;
        if (count <= Manifold.MOST) {
            for (int i = 0; i < count; i++) {
                emit(i, nX, nY, nZ, out);
            }
            return;
        }
        int a = deepest();
        int b = farthest(a);
        int c = widest(a, b, nX, nY, nZ, 1);
        int d = widest(a, b, nX, nY, nZ, -1);
        emit(a, nX, nY, nZ, out);
        emit(b, nX, nY, nZ, out);
        if (c >= 0) {
            emit(c, nX, nY, nZ, out);
        }
        if (d >= 0) {
            emit(d, nX, nY, nZ, out);
        }
    }

    private void copyWithin(int from, int to) {
        p[3 * to] = p[3 * from];
        p[3 * to + 1] = p[3 * from + 1];
        p[3 * to + 2] = p[3 * from + 2];
        id[to] = id[from];
    }

    private int deepest() {
        int best = 0;
        for (int i = 1; i < count; i++) {
            best = depth[i] < depth[best] - tolerance / 8 ? i : best;
        }
        return best;
    }

    private int farthest(int from) {
        int best = from;
        double most = -1;
        for (int i = 0; i < count; i++) {
            double x = p[3 * i] - p[3 * from];
            double y = p[3 * i + 1] - p[3 * from + 1];
            double z = p[3 * i + 2] - p[3 * from + 2];
            double square = x * x + y * y + z * z;
            if (square > most + 1e-9) {
                most = square;
                best = i;
            }
        }
        return best;
    }

    private int widest(int a, int b, double nX, double nY, double nZ, int sign) {
        double dX = p[3 * b] - p[3 * a];
        double dY = p[3 * b + 1] - p[3 * a + 1];
        double dZ = p[3 * b + 2] - p[3 * a + 2];
        int best = -1;
        double most = 1e-12;
        for (int i = 0; i < count; i++) {
            double x = p[3 * i] - p[3 * a];
            double y = p[3 * i + 1] - p[3 * a + 1];
            double z = p[3 * i + 2] - p[3 * a + 2];
            double area = sign * (nX * (dY * z - dZ * y) + nY * (dZ * x - dX * z) + nZ * (dX * y - dY * x));
            if (i != a && i != b && area > most + 1e-9) {
                most = area;
                best = i;
            }
        }
        return best;
    }

    private void emit(int i, double nX, double nY, double nZ, Manifold out) {
        double back = depth[i] / 2;
        out.add(p[3 * i] - back * nX, p[3 * i + 1] - back * nY, p[3 * i + 2] - back * nZ, depth[i], id[i]);
    }
}
