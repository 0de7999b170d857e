package nephele.engine.portal;

import nephele.engine.level.PortalShape;

/**
 * The opening of a portal: a convex polygon in the portal's plane. x runs to the right and y up as seen from in front,
 * in metres from the centre of the bounding rectangle; corners are counter-clockwise. The same polygon is drawn and
 * passed.
 */
public final class Aperture {
    /** Greatest number of corners of any shape. */
    public static final int MOST_CORNERS = 24;

    private static final int ARCH_SEGMENTS = 20;

    private final PortalShape shape;
    private final double widthMetres;
    private final double heightMetres;
    private final double[] corners;
    /** For each edge: outward unit normal x, y and distance from the centre. */
    private final double[] edges;

    private Aperture(PortalShape shape, double widthMetres, double heightMetres, double[] corners) {
        this.shape = shape;
        this.widthMetres = widthMetres;
        this.heightMetres = heightMetres;
        this.corners = corners;
        edges = edges(corners);
    }

    /**
     * Makes an aperture. An arch has a flat bottom as wide as itself, vertical sides and a round top; if its height is
     * less than half its width, the top is half an ellipse.
     */
    public static Aperture of(PortalShape shape, double widthMetres, double heightMetres) {
        return new Aperture(shape, widthMetres, heightMetres, corners(shape, widthMetres / 2, heightMetres / 2));
    }

    private static double[] corners(PortalShape shape, double x, double y) {
        if (shape == PortalShape.RECTANGLE) {
            return new double[] {-x, -y, x, -y, x, y, -x, y};
        }
        return shape == PortalShape.ELLIPSE ? ellipse(x, y) : arch(x, y);
    }

    private static double[] ellipse(double x, double y) {
        double[] corners = new double[2 * MOST_CORNERS];
        for (int i = 0; i < MOST_CORNERS; i++) {
            double angle = 2 * Math.PI * i / MOST_CORNERS;
            corners[2 * i] = x * StrictMath.cos(angle);
            corners[2 * i + 1] = y * StrictMath.sin(angle);
        }
        return corners;
    }

    private static double[] arch(double x, double y) {
        double rise = Math.min(x, 2 * y);
        double springing = y - rise;
        boolean hasSides = springing > -y;
        double[] corners = new double[2 * (ARCH_SEGMENTS + 1 + (hasSides ? 2 : 0))];
        int at = 0;
        if (hasSides) {
            corners[at++] = -x;
            corners[at++] = -y;
            corners[at++] = x;
            corners[at++] = -y;
        }
        for (int i = 0; i <= ARCH_SEGMENTS; i++) {
            double angle = Math.PI * i / ARCH_SEGMENTS;
            corners[at++] = i == 0 ? x : i == ARCH_SEGMENTS ? -x : x * StrictMath.cos(angle);
            corners[at++] = i == 0 || i == ARCH_SEGMENTS ? springing : springing + rise * StrictMath.sin(angle);
        }
        return corners;
    }

    private static double[] edges(double[] corners) {
        int count = corners.length / 2;
        double[] edges = new double[3 * count];
        for (int i = 0; i < count; i++) {
            int j = (i + 1) % count;
            double dx = corners[2 * j] - corners[2 * i];
            double dy = corners[2 * j + 1] - corners[2 * i + 1];
            double length = Math.sqrt(dx * dx + dy * dy);
            edges[3 * i] = dy / length;
            edges[3 * i + 1] = -dx / length;
            edges[3 * i + 2] = (dy * corners[2 * i] - dx * corners[2 * i + 1]) / length;
        }
        return edges;
    }

    /** Returns the shape from which the polygon was made. */
    public PortalShape shape() {
        return shape;
    }

    /** Returns the width of the bounding rectangle. */
    public double widthMetres() {
        return widthMetres;
    }

    /** Returns the height of the bounding rectangle. */
    public double heightMetres() {
        return heightMetres;
    }

    /** Returns the number of corners. */
    public int corners() {
        return corners.length / 2;
    }

    /** Returns a corner's distance to the right of the centre, in metres. */
    public double cornerX(int corner) {
        return corners[2 * corner];
    }

    /** Returns a corner's distance above the centre, in metres. */
    public double cornerY(int corner) {
        return corners[2 * corner + 1];
    }

    /** Returns a component of the outward unit normal of the edge from a corner to the next. */
    public double edgeNormalX(int edge) {
        return edges[3 * edge];
    }

    public double edgeNormalY(int edge) {
        return edges[3 * edge + 1];
    }

    /** Returns the distance in metres from the centre to the line through an edge. */
    public double edgeDistance(int edge) {
        return edges[3 * edge + 2];
    }

    /** Returns the distance in metres of a point outside the farthest edge's line; not positive within the aperture. */
    public double outside(double x, double y) {
        double most = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < edges.length; i += 3) {
            most = Math.max(most, edges[i] * x + edges[i + 1] * y - edges[i + 2]);
        }
        return most;
    }

    /** Returns true if a point is within the aperture or on its edge. */
    public boolean contains(double x, double y) {
        return outside(x, y) <= 0;
    }
}
