package nephele.lab.placement;

import java.util.List;

/**
 * Decides by areas whether an aperture is whole: no part of it is outside the surface's pieces or on an obstacle. It
 * clips polygons (Sutherland and Hodgman 1974) and shares no code with the placement that it judges.
 */
public final class ClippedAreas {
    /** Tolerance for rounding, in square metres. A corner that exceeds an edge by 3·10⁻⁷ m gives more. */
    static final double NOTHING = 1e-13;

    /** The pieces on which portals are allowed: convex, counter-clockwise and disjoint. */
    private final List<double[]> pieces;
    /** The obstacles: convex and counter-clockwise; they may overlap. */
    private final List<double[]> inTheWay;

    /** Creates a wall of pieces, with obstacles on it. */
    public ClippedAreas(List<double[]> pieces, List<double[]> inTheWay) {
        this.pieces = pieces;
        this.inTheWay = inTheWay;
    }

    /** @param shape an aperture's corners around its centre */
    public boolean isWhole(double[] shape, double x, double y) {
        double[] placed = new double[shape.length];
        for (int i = 0; i < shape.length; i += 2) {
            placed[i] = shape[i] + x;
            placed[i + 1] = shape[i + 1] + y;
        }
        return mayBeWhole(placed, x, y) && missing(placed) <= NOTHING;
    }

    /** Tests the centre and a few corners first, which rejects most places. */
    private boolean mayBeWhole(double[] placed, double x, double y) {
        if (!isOnPiece(x, y)) {
            return false;
        }
        for (int i = 0; i < placed.length; i += 6) {
            if (!isOnPiece(placed[i], placed[i + 1])) {
                return false;
            }
        }
        return true;
    }

    private boolean isOnPiece(double x, double y) {
        return pieces.stream().anyMatch(piece -> contains(piece, x, y));
    }

    /** Returns true if a point is in a convex counter-clockwise polygon. */
    public static boolean contains(double[] polygon, double x, double y) {
        for (int i = 0; i < polygon.length; i += 2) {
            int j = (i + 2) % polygon.length;
            double dx = polygon[j] - polygon[i];
            double dy = polygon[j + 1] - polygon[i + 1];
            double length = Math.sqrt(dx * dx + dy * dy);
            if (dx * (y - polygon[i + 1]) - dy * (x - polygon[i]) < -1e-9 * length) {
                return false;
            }
        }
        return true;
    }

    private double missing(double[] placed) {
        double missing = area(placed);
        for (double[] piece : pieces) {
            missing -= overlap(placed, piece);
        }
        for (double[] obstacle : inTheWay) {
            missing += overlap(placed, obstacle);
        }
        return missing;
    }

    static double overlap(double[] polygon, double[] window) {
        double[] left = polygon;
        for (int i = 0; i < window.length && left.length > 4; i += 2) {
            int j = (i + 2) % window.length;
            left = clipped(left, window[i], window[i + 1], window[j] - window[i], window[j + 1] - window[i + 1]);
        }
        return area(left);
    }

    /** Returns the part of the polygon to the left of the line through (x, y) along (dx, dy). */
    private static double[] clipped(double[] polygon, double x, double y, double dx, double dy) {
        double[] kept = new double[2 * polygon.length + 4];
        int size = 0;
        for (int i = 0; i < polygon.length; i += 2) {
            int j = (i + 2) % polygon.length;
            double side = dx * (polygon[i + 1] - y) - dy * (polygon[i] - x);
            double next = dx * (polygon[j + 1] - y) - dy * (polygon[j] - x);
            if (side >= 0) {
                kept[size++] = polygon[i];
                kept[size++] = polygon[i + 1];
            }
            if (side >= 0 != next >= 0) {
                double fraction = side / (side - next);
                kept[size++] = polygon[i] + fraction * (polygon[j] - polygon[i]);
                kept[size++] = polygon[i + 1] + fraction * (polygon[j + 1] - polygon[i + 1]);
            }
        }
        return java.util.Arrays.copyOf(kept, size);
    }

    private static double area(double[] polygon) {
        double doubled = 0;
        for (int i = 2; i + 3 < polygon.length; i += 2) {
            doubled += (polygon[i] - polygon[0]) * (polygon[i + 3] - polygon[1])
                    - (polygon[i + 2] - polygon[0]) * (polygon[i + 1] - polygon[1]);
        }
        return doubled / 2;
    }
}
