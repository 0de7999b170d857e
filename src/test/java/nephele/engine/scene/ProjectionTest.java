package nephele.engine.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import nephele.engine.math.Basis;
import nephele.engine.math.Vec3;
import org.joml.Matrix4d;
import org.joml.Vector4d;
import org.joml.Vector4f;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The matrix of {@link View#clipFromRelative} and the depth terms are finite, exact and ordered. */
class ProjectionTest {
    private static final Vec3 AHEAD = new Vec3(0, 0, -1);
    private static final Vec3 UP = new Vec3(0, 1, 0);

    /** Returns the matrix of a view along −z, which has the world's axes. */
    private static Matrix4d clip(Projection projection) {
        return View.lookAt(Vec3.ZERO, AHEAD, UP, projection).clipFromRelative(new Matrix4d());
    }

    /** No input results in a non-finite number, for 10⁵ bit patterns. */
    @Test
    void everyBitPatternGivesAFiniteMatrix() {
        var random = new SplittableRandom(4);
        double[] numbers = new double[16];
        for (int i = 0; i < 100_000; i++) {
            double a = anyDouble(random);
            double b = anyDouble(random);
            Projection p = i % 2 == 0
                    ? new Projection(a, b, anyDouble(random), anyDouble(random))
                    : Projection.ofHorizontalFov(a, b, anyDouble(random), anyDouble(random));
            double fov = Math.toDegrees(p.verticalFovRadians());
            assertTrue(fov >= 1 - 1e-9 && fov <= 170 + 1e-9, p::toString);
            assertTrue(p.nearMetres() >= 1e-3 && p.farMetres() >= p.nearMetres() * (1 + 1e-3), p::toString);
            assertTrue(p.aspect() > 0 && p.aspect() <= 1000, p::toString);
            for (double value : clip(p).get(numbers)) {
                assertTrue(Float.isFinite((float) value), p::toString);
            }
        }
    }

    private static double anyDouble(SplittableRandom random) {
        return switch (random.nextInt(5)) {
            case 0 -> Double.longBitsToDouble(random.nextLong());
            case 1 ->
                new double[] {0, -0.0, Double.NaN, Double.POSITIVE_INFINITY, Double.MIN_VALUE, Math.PI}
                        [random.nextInt(6)];
            default -> random.nextDouble(-1, 4);
        };
    }

    @Test
    void nearFarAndBordersMapToTheFacesOfClipSpace() {
        Projection p = Projection.ofHorizontalFov(Math.toRadians(90), 2, 0.1, 50);
        Vector4d near = clip(p).transform(new Vector4d(0.1, 0.05, -0.1, 1));
        assertEquals(-1, near.z / near.w, 1e-12);
        assertEquals(1, near.x / near.w, 1e-12);
        assertEquals(1, near.y / near.w, 1e-12);
        Vector4d far = clip(p).transform(new Vector4d(0, 0, -50, 1));
        assertEquals(1, far.z / far.w, 1e-12);
        var infinite = new Projection(1, 1, 0.1, Double.POSITIVE_INFINITY);
        Vector4d horizon = clip(infinite).transform(new Vector4d(0, 0, -1, 0));
        assertEquals(1, horizon.z / horizon.w, 0);
    }

    /** Surfaces two steps of a 24-bit depth buffer apart keep their order when depth is computed in float. */
    @Test
    void surfacesTwoQuantaApartKeepTheirOrderInTwentyFourBits() {
        var random = new SplittableRandom(3);
        for (int i = 0; i < 100_000; i++) {
            double near = 0.05 + random.nextDouble();
            double far = i % 3 == 0 ? Double.POSITIVE_INFINITY : near * (2 + 1e4 * random.nextDouble());
            var p = new Projection(1, 1, near, far);
            double z = near * Math.pow(Math.min(far / near, 1e5), random.nextDouble());
            double behind = z + 2 * quantumMetres(near, far, z);
            assertTrue(depthCode(p, z) < depthCode(p, behind) || behind > far, p + " at " + z);
        }
    }

    /**
     * Returns the inverse slope of window depth, z² (f − n) / (f n), times two steps: the buffer's and the rounding of
     * z / w to float.
     */
    private static double quantumMetres(double near, double far, double z) {
        return z * z * (1 / near - 1 / far) * 0x1p-23;
    }

    private static long depthCode(Projection p, double distance) {
        float z = (float) p.depthScale() * (float) -distance + (float) p.depthOffset();
        float window = 0.5f * (z / (float) distance) + 0.5f;
        return Math.round(window * (double) ((1 << 24) - 1));
    }

    /** Window depth is (1/n − 1/z) / (1/n − 1/f), which gives the number of steps between two distances. */
    @ParameterizedTest
    @CsvSource({"0.2, 0.3", "1, 2", "10, 15", "100, 140", "900, 990"})
    void depthHasTheStepsOfItsFormula(double from, double to) {
        var p = new Projection(1, 1, 0.1, 1000);
        double steps = (1 / from - 1 / to) / (1 / p.nearMetres() - 1 / p.farMetres()) * ((1 << 24) - 1);
        assertEquals(steps, depthCode(p, to) - depthCode(p, from), 3);
    }

    /** At 10⁷ m the picture of a point moves by at most 0.1 px of 1080 lines. */
    @Test
    void tenThousandKilometresOutAPointStaysWithinATenthOfAPixel() {
        var random = new SplittableRandom(1);
        double worst = 0;
        for (int i = 0; i < 20_000; i++) {
            Vec3 eye = new Vec3(1e7 + random.nextDouble(), -1e7 * random.nextDouble(), 1e7);
            Basis basis = Basis.ofYawPitch(random.nextDouble(-3, 3), random.nextDouble(-1.5, 1.5));
            var projection = new Projection(1.2, 16 / 9.0, 0.05, 1e5);
            Matrix4d clip =
                    new View(eye, basis.right(), basis.up(), basis.back(), projection).clipFromRelative(new Matrix4d());
            // Exact: the offset from the eye is a multiple of a step that a double represents at 10⁷.
            Vec3 back = basis.back();
            double distance = Math.rint(Math.pow(10, random.nextDouble(-0.5, 3)) * 1024) / 1024;
            double x = step(-back.x() * distance + random.nextDouble(-0.3, 0.3) * distance);
            double y = step(-back.y() * distance + random.nextDouble(-0.3, 0.3) * distance);
            double z = step(-back.z() * distance + random.nextDouble(-0.3, 0.3) * distance);
            Vec3 base = new Vec3(step(eye.x()), step(eye.y()), step(eye.z()));
            Vector4d exact = clip.transform(new Vector4d(x, y, z, 1));
            if (exact.w < 0.1) {
                continue;
            }
            Vec3 point = new Vec3(base.x() + x, base.y() + y, base.z() + z);
            Vector4f rounded = new org.joml.Matrix4f(clip)
                    .transform(new Vector4f(
                            (float) (point.x() - base.x()),
                            (float) (point.y() - base.y()),
                            (float) (point.z() - base.z()),
                            1));
            worst = Math.max(worst, 960 * Math.abs(exact.x / exact.w - rounded.x / rounded.w));
            worst = Math.max(worst, 540 * Math.abs(exact.y / exact.w - rounded.y / rounded.w));
        }
        assertTrue(worst <= 0.1, worst + " px");
    }

    private static double step(double metres) {
        return Math.rint(metres * 0x1p20) * 0x1p-20;
    }
}
