package nephele.engine.portal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import java.util.stream.IntStream;
import nephele.engine.level.PortalShape;
import org.junit.jupiter.api.Test;

/** An aperture is one convex polygon of at most 24 sides; the default arch has a flat bottom edge of at least 0.8 m. */
class ApertureTest {
    private static final double[] SIZES = {0.01, 0.1, 0.7, 1.2, 2.1, 33, 1e4};

    private interface Check {
        void of(Aperture aperture);
    }

    private static void forAll(Check check) {
        for (PortalShape shape : PortalShape.values()) {
            for (double width : SIZES) {
                for (double height : SIZES) {
                    check.of(Aperture.of(shape, width, height));
                }
            }
        }
    }

    @Test
    void everyShapeIsConvexAndCounterClockwiseWithAtMost24Corners() {
        forAll(aperture -> {
            int n = aperture.corners();
            assertTrue(n >= 4 && n <= 24 && n <= Aperture.MOST_CORNERS);
            for (int i = 0; i < n; i++) {
                double ax = aperture.cornerX((i + 1) % n) - aperture.cornerX(i);
                double ay = aperture.cornerY((i + 1) % n) - aperture.cornerY(i);
                double bx = aperture.cornerX((i + 2) % n) - aperture.cornerX((i + 1) % n);
                double by = aperture.cornerY((i + 2) % n) - aperture.cornerY((i + 1) % n);
                assertTrue(ax * by - ay * bx > 0, aperture.shape() + " turns right at corner " + (i + 1));
            }
        });
    }

    @Test
    void everyShapeFillsItsRectangleExactly() {
        forAll(aperture -> {
            double w = aperture.widthMetres() / 2;
            double h = aperture.heightMetres() / 2;
            assertEquals(w, reach(aperture, 1, 0), 1e-15 * w);
            assertEquals(w, reach(aperture, -1, 0), 1e-15 * w);
            assertEquals(h, reach(aperture, 0, 1), 1e-15 * h);
            assertEquals(h, reach(aperture, 0, -1), 1e-15 * h);
        });
    }

    private static double reach(Aperture aperture, double x, double y) {
        return IntStream.range(0, aperture.corners())
                .mapToDouble(i -> aperture.cornerX(i) * x + aperture.cornerY(i) * y)
                .max()
                .orElseThrow();
    }

    @Test
    void edgesAreThoseBetweenTheCorners() {
        forAll(aperture -> {
            double size = aperture.widthMetres() + aperture.heightMetres();
            for (int i = 0; i < aperture.corners(); i++) {
                double nx = aperture.edgeNormalX(i);
                double ny = aperture.edgeNormalY(i);
                assertEquals(1, nx * nx + ny * ny, 1e-12);
                int next = (i + 1) % aperture.corners();
                assertEquals(
                        aperture.edgeDistance(i),
                        nx * aperture.cornerX(next) + ny * aperture.cornerY(next),
                        1e-14 * size);
                assertEquals(aperture.edgeDistance(i), reach(aperture, nx, ny), 1e-14 * size);
            }
        });
    }

    @Test
    void theDefaultArchHasAFlatBottomAndARoundTop() {
        Aperture arch = Aperture.of(PortalShape.ARCH, 1.2, 2.1);
        double bottom = 0;
        for (int i = 0; i < arch.corners(); i++) {
            int next = (i + 1) % arch.corners();
            if (arch.cornerY(i) == -1.05 && arch.cornerY(next) == -1.05) {
                bottom = arch.cornerX(next) - arch.cornerX(i);
            }
        }
        assertTrue(bottom >= 0.8, "the bottom is " + bottom + " m wide");
        for (double angle = 0; angle < Math.PI; angle += 0.01) {
            double off = arch.outside(0.6 * Math.cos(angle), 0.45 + 0.6 * Math.sin(angle));
            assertTrue(off >= -1e-12 && off < 0.002, "the top is not round at " + angle);
        }
        assertTrue(arch.contains(0.59, -1.04));
        assertFalse(arch.contains(0.59, 1.04));
    }

    /** Without room for a semicircle, the top is half an ellipse on the flat bottom. */
    @Test
    void anArchLowerThanHalfItsWidthIsAllTop() {
        Aperture low = Aperture.of(PortalShape.ARCH, 4, 1);
        assertTrue(low.contains(-1.99, -0.499) && low.contains(0, 0.49));
        assertFalse(low.contains(1.9, 0.2));
    }

    @Test
    void containsAgreesWithTheShapesFormula() {
        SplittableRandom random = new SplittableRandom(1);
        Aperture ellipse = Aperture.of(PortalShape.ELLIPSE, 1.4, 2.2);
        Aperture rectangle = Aperture.of(PortalShape.RECTANGLE, 1.4, 2.2);
        for (int i = 0; i < 10_000; i++) {
            double x = random.nextDouble(-1, 1);
            double y = random.nextDouble(-1.5, 1.5);
            assertEquals(Math.abs(x) <= 0.7 && Math.abs(y) <= 1.1, rectangle.contains(x, y));
            double radius = Math.sqrt(x * x / 0.49 + y * y / 1.21);
            // 24 chords omit a hundredth of the circle.
            if (radius > 1 || radius < 0.99) {
                assertEquals(radius < 1, ellipse.contains(x, y));
            }
        }
    }
}
