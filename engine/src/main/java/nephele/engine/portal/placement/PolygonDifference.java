package nephele.engine.portal.placement;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** Computes the part of a convex polygon that others do not cover, as convex pieces. */
final class PolygonDifference {
    /** Least width of a piece; thinner ones are rounding, or cracks between the triangles of a mesh. */
    private static final double THINNEST_METRES = Tolerance.CRACK;

    private List<ConvexPolygon> pieces;

    PolygonDifference(ConvexPolygon whole) {
        pieces = List.of(whole);
    }

    /** Subtracts a polygon. */
    void cover(ConvexPolygon cover) {
        List<ConvexPolygon> left = new ArrayList<>();
        for (ConvexPolygon piece : pieces) {
            if (ConvexPolygon.gap(piece, cover) >= 0) {
                left.add(piece);
            } else {
                addOutside(piece, cover, left);
            }
        }
        pieces = left;
    }

    private static void addOutside(ConvexPolygon piece, ConvexPolygon cover, List<ConvexPolygon> left) {
        ConvexPolygon rest = piece;
        for (int edge = 0; edge < cover.corners() && rest != null; edge++) {
            ConvexPolygon outside = cut(rest, cover, edge, 1);
            if (outside != null) {
                left.add(outside);
            }
            rest = cut(rest, cover, edge, -1);
        }
    }

    /** Returns an estimate of the width of the widest piece; 0 if all is covered. */
    double widthMetres() {
        return pieces.stream().mapToDouble(PolygonDifference::width).max().orElse(0);
    }

    /** Clips by the line along an edge (Sutherland and Hodgman 1974); {@code null} if the rest is too thin. */
    private static ConvexPolygon cut(ConvexPolygon polygon, ConvexPolygon cover, int edge, int side) {
        double[] kept = new double[4 * polygon.corners()];
        int size = 0;
        for (int i = 0; i < polygon.corners(); i++) {
            int next = (i + 1) % polygon.corners();
            double here = side * ahead(cover, edge, polygon.x(i), polygon.y(i));
            double there = side * ahead(cover, edge, polygon.x(next), polygon.y(next));
            if (here >= 0) {
                kept[size++] = polygon.x(i);
                kept[size++] = polygon.y(i);
            }
            if (here < 0 != there < 0) {
                double share = here / (here - there);
                kept[size++] = polygon.x(i) + share * (polygon.x(next) - polygon.x(i));
                kept[size++] = polygon.y(i) + share * (polygon.y(next) - polygon.y(i));
            }
        }
        ConvexPolygon clipped = ConvexPolygon.of(Arrays.copyOf(kept, size));
        return clipped.corners() > 2 && width(clipped) > THINNEST_METRES ? clipped : null;
    }

    private static double ahead(ConvexPolygon cover, int edge, double x, double y) {
        return cover.normalX(edge) * x + cover.normalY(edge) * y - cover.distance(edge);
    }

    /** Returns the width of a rectangle; for other shapes at most half too little. */
    private static double width(ConvexPolygon polygon) {
        double doubledArea = 0;
        double longest = 0;
        for (int i = 0; i < polygon.corners(); i++) {
            int next = (i + 1) % polygon.corners();
            doubledArea += (polygon.x(i) - polygon.x(0)) * (polygon.y(next) - polygon.y(0))
                    - (polygon.x(next) - polygon.x(0)) * (polygon.y(i) - polygon.y(0));
            longest = Math.max(longest, polygon.length(i));
        }
        return longest > 0 ? doubledArea / 2 / longest : 0;
    }
}
