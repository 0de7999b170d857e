package nephele.engine.portal.placement;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** The outlines of unions have the known lengths. */
class OutlineTest {
    private static ConvexPolygon rectangle(double x0, double y0, double x1, double y1) {
        return ConvexPolygon.of(new double[] {x0, y0, x1, y0, x1, y1, x0, y1});
    }

    private static List<ConvexPolygon> outline(ConvexPolygon... polygons) {
        return Outline.of(new PolygonIndex(List.of(polygons)));
    }

    private static double length(List<ConvexPolygon> segments) {
        return segments.stream().mapToDouble(segment -> segment.length(0)).sum();
    }

    @Test
    void piecesSideBySideHaveTheEdgesOfTheWhole() {
        List<ConvexPolygon> outline =
                outline(rectangle(0, 0, 1, 2), rectangle(1, 0, 3, 1), rectangle(1, 1, 1.5, 2), rectangle(1.5, 1, 3, 2));
        assertEquals(4, outline.size());
        assertEquals(10, length(outline), 1e-9);
    }

    @Test
    void overlappingPiecesHaveTheEdgesOfTheirUnion() {
        List<ConvexPolygon> cross = outline(rectangle(-3, -1, 3, 1), rectangle(-1, -3, 1, 3));
        assertEquals(12, cross.size());
        assertEquals(24, length(cross), 1e-9);
        for (ConvexPolygon segment : cross) {
            assertEquals(2, segment.length(0), 1e-9, "it ends at the corner exactly");
        }
    }

    @Test
    void twiceTheSameIsOnce() {
        List<ConvexPolygon> twice = outline(rectangle(0, 0, 1, 2), rectangle(0, 0, 1, 2), rectangle(0.5, 0, 1, 2));
        assertTrue(
                length(twice) >= 6 && twice.stream().allMatch(OutlineTest::isOnUnit), "all edges are the outer ones");
    }

    private static boolean isOnUnit(ConvexPolygon segment) {
        double x = (segment.x(0) + segment.x(1)) / 2;
        double y = (segment.y(0) + segment.y(1)) / 2;
        return Math.abs(rectangle(0, 0, 1, 2).outside(x, y)) < 1e-9;
    }

    @Test
    void aCrackIsNoEdgeAndASlitIs() {
        double wide = 2 * Tolerance.CRACK;
        assertEquals(
                4,
                outline(rectangle(0, 0, 1, 2), rectangle(1 + 0.9 * wide, 0, 3, 2))
                        .size());
        assertEquals(
                8,
                outline(rectangle(0, 0, 1, 2), rectangle(1 + 1.1 * wide, 0, 3, 2))
                        .size());
    }

    /** A triangular hole of 12° keeps its tip. */
    @Test
    void holesKeepTheirTips() {
        double tip = 0.1;
        List<ConvexPolygon> parts = new ArrayList<>(List.of(
                ConvexPolygon.of(new double[] {0, 0, 1, 0, 1 - tip, 1, 0, 1}),
                ConvexPolygon.of(new double[] {1, 0, 2, 0, 2, 1, 1 + tip, 1})));
        List<ConvexPolygon> outline = outline(parts.toArray(new ConvexPolygon[0]));
        double side = Math.sqrt(1 + tip * tip);
        assertEquals(2 + 2 + 2 * (1 - tip) + 2 * side, length(outline), 2e-6);
    }

    /** Holes of 5.7° and 0.6° keep their tips; the part as narrow as a crack is longer than any corner's. */
    @Test
    void sharpHolesKeepTheirTips() {
        for (double wide : new double[] {0.1, 0.01}) {
            List<ConvexPolygon> outline = outline(
                    ConvexPolygon.of(new double[] {0, 0, 1, 0, 1, 1, 0, 1}),
                    ConvexPolygon.of(new double[] {1, 0, 2, 0, 2, 1, 1 + wide, 1}));
            assertEquals(6 - wide + Math.sqrt(1 + wide * wide) + 1, length(outline), 1e-6 + 2e-7 / wide);
        }
    }

    /** A crack that ends at a hole is not a tip, if it widens towards the hole or has constant width. */
    @Test
    void cracksThatEndAtAHoleAreNoTips() {
        for (double wide : new double[] {2e-5, Tolerance.CRACK, 1.8 * Tolerance.CRACK}) {
            List<ConvexPolygon> outline = outline(
                    ConvexPolygon.of(new double[] {0, 0, 4, 0, 4, 1, 0, 1}),
                    ConvexPolygon.of(new double[] {0, 1, 1, 1 + wide, 1, 2, 0, 2}),
                    ConvexPolygon.of(new double[] {3, 1 + wide, 4, 1 + wide, 4, 2, 3, 2}));
            assertEquals(14, length(outline), 1e-3);
        }
    }

    /** The longest piece is inclined by 2·10⁻⁵ over 0.75 m, which moves its line 10⁻⁴ off the far end. */
    @Test
    void noiseInTheLongestPieceDoesNotBreakTheEdge() {
        List<ConvexPolygon> pieces = new ArrayList<>();
        pieces.add(ConvexPolygon.of(new double[] {0, -1e-5, 0.75, 1e-5, 0.75, 2, 0, 2}));
        for (int i = 0; i < 5; i++) {
            double x = 0.75 + 0.6 * i;
            pieces.add(ConvexPolygon.of(new double[] {x, -1e-5, x + 0.6, -1e-5, x + 0.6, 2, x, 2}));
        }
        List<ConvexPolygon> outline = outline(pieces.toArray(new ConvexPolygon[0]));
        assertEquals(
                1,
                outline.stream()
                        .filter(segment -> segment.length(0) > 1e-4 && segment.normalY(0) < -0.9)
                        .count());
    }

    @Test
    void noiseInPiecesOfOneEdgeIsStraightened() {
        List<ConvexPolygon> outline = outline(
                rectangle(0, 0, 1, 2), rectangle(1, 1e-5, 2, 2), rectangle(2, -1e-5, 3, 2), rectangle(3, 5e-6, 4, 2));
        assertEquals(4, outline.size());
        for (ConvexPolygon segment : outline) {
            if (segment.normalY(0) < -0.9) {
                assertTrue(segment.y(0) >= 1e-5 && segment.y(0) < 3e-5, "on the inner side of all");
                assertEquals(0, segment.normalX(0), 1e-5);
            }
        }
    }
}
