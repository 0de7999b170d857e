package nephele.engine.scene;

/**
 * A convex polygon in front of an eye, in the picture's homogeneous coordinates: points with x/w and y/w from −1 to 1
 * are in the picture, w is the distance along the view in metres. Nothing is divided by w before the polygon has been
 * clipped to the picture's sides, so that the polygon may reach behind the eye and pass arbitrarily close to it.
 * Corners are counter-clockwise.
 */
public final class PicturePolygon {
    /** The greatest number of corners: further clipping is skipped, and the polygon stays too large. */
    public static final int MOST_CORNERS = 64;

    /**
     * The length in picture coordinates below which an edge of the clipping polygon is skipped: rounding decides its
     * direction, which between two nearly equal corners may even be reversed.
     */
    private static final double SHORTEST_EDGE = 1e-8;

    private double[] corners = new double[3 * (MOST_CORNERS + 1)];
    private double[] cut = new double[3 * (MOST_CORNERS + 1)];
    private int size;

    void clear() {
        size = 0;
    }

    void add(double x, double y, double w) {
        int at = 3 * size++;
        corners[at] = x;
        corners[at + 1] = y;
        corners[at + 2] = w;
    }

    /** Copies the corners of another polygon. */
    public void copy(PicturePolygon other) {
        System.arraycopy(other.corners, 0, corners, 0, 3 * other.size);
        size = other.size;
    }

    public int size() {
        return size;
    }

    public boolean isEmpty() {
        return size < 3;
    }

    public double x(int corner) {
        return corners[3 * corner];
    }

    public double y(int corner) {
        return corners[3 * corner + 1];
    }

    public double w(int corner) {
        return corners[3 * corner + 2];
    }

    /** Clips to the half-space a·x + b·y + c·w ≥ 0. */
    void keep(double a, double b, double c) {
        keep(a, b, c, 0);
    }

    /** Clips to a·x + b·y + c·w + d ≥ 0, a plane that need not pass through the eye (Sutherland and Hodgman 1974). */
    void keep(double a, double b, double c, double d) {
        if (size >= MOST_CORNERS || isEmpty()) {
            return;
        }
        int kept = 0;
        int last = size - 1;
        double before = a * x(last) + b * y(last) + c * w(last) + d;
        for (int i = 0; i < size; i++) {
            double here = a * x(i) + b * y(i) + c * w(i) + d;
            if (before < 0 != here < 0) {
                kept = cross(last, i, before / (before - here), kept);
            }
            if (here >= 0) {
                System.arraycopy(corners, 3 * i, cut, 3 * kept++, 3);
            }
            before = here;
            last = i;
        }
        double[] swap = corners;
        corners = cut;
        cut = swap;
        size = kept;
    }

    private int cross(int from, int to, double fraction, int kept) {
        for (int i = 0; i < 3; i++) {
            double start = corners[3 * from + i];
            cut[3 * kept + i] = start + fraction * (corners[3 * to + i] - start);
        }
        return kept + 1;
    }

    /** Clips to the part at most {@code metres} away along the view. */
    public void keepNearer(double metres) {
        keep(0, 0, -1, metres);
    }

    /** Clips to the part at least {@code metres} away along the view. */
    public void keepFarther(double metres) {
        keep(0, 0, 1, -metres);
    }

    /** Clips to {@code reach} times the picture's bounds. */
    void keepInPicture(double reach) {
        keep(1, 0, reach);
        keep(-1, 0, reach);
        keep(0, 1, reach);
        keep(0, -1, reach);
    }

    /** Clips to the part seen through {@code other}, which must be within the picture. */
    void keepWithin(PicturePolygon other) {
        int from = other.size - 1;
        for (int to = 0; to < other.size && !isEmpty(); to++) {
            double x0 = other.x(from) / other.w(from);
            double y0 = other.y(from) / other.w(from);
            double x1 = other.x(to) / other.w(to);
            double y1 = other.y(to) / other.w(to);
            if (Math.max(Math.abs(x1 - x0), Math.abs(y1 - y0)) > SHORTEST_EDGE) {
                keep(y0 - y1, x1 - x0, x0 * y1 - x1 * y0);
            }
            from = to;
        }
    }

    /**
     * Returns the greatest signed distance of a point of the picture to the lines of the edges, positive outside; it is
     * not positive within the polygon.
     */
    double outside(double atX, double atY) {
        double most = Double.NEGATIVE_INFINITY;
        int from = size - 1;
        for (int to = 0; to < size; to++) {
            double dx = x(to) / w(to) - x(from) / w(from);
            double dy = y(to) / w(to) - y(from) / w(from);
            double length = Math.sqrt(dx * dx + dy * dy);
            if (length > 1e-12) {
                double left = dx * (atY - y(from) / w(from)) - dy * (atX - x(from) / w(from));
                most = Math.max(most, -left / length);
            }
            from = to;
        }
        return most;
    }

    /** Returns the covered fraction of the picture; the polygon must be within the picture. */
    double fraction() {
        double twice = 0;
        int from = size - 1;
        for (int to = 0; to < size; to++) {
            twice += x(from) / w(from) * (y(to) / w(to)) - x(to) / w(to) * (y(from) / w(from));
            from = to;
        }
        return twice / 8;
    }

    /** Returns the least w, metres. */
    double nearest() {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < size; i++) {
            least = Math.min(least, w(i));
        }
        return least;
    }

    /** Returns the polygon's support along a direction of the picture, in picture coordinates. */
    double support(double alongX, double alongY) {
        double most = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < size; i++) {
            most = Math.max(most, (alongX * x(i) + alongY * y(i)) / w(i));
        }
        return most;
    }
}
