package nephele.engine.scene.light;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import java.util.function.DoubleBinaryOperator;
import java.util.stream.IntStream;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ShadowFilterTest {
    private static final double HALF_TEXEL = 0.01;
    private static final boolean[] ALL = {true, true, true, true};
    private static final double[] EVENLY = {0.25, 0.25, 0.25, 0.25};

    /** A plane never shades itself at any slope, because each texel is compared with the plane's depth there. */
    @Test
    void aSlopingPlaneIsLitEverywhere() {
        SplittableRandom random = new SplittableRandom(7);
        for (int i = 0; i < 2000; i++) {
            double gx = random.nextDouble() - 0.5;
            double gy = random.nextDouble() - 0.5;
            double x = random.nextDouble() * 50;
            double y = random.nextDouble() * 50;
            var four = ShadowFilter.Footprint.at(x, y);
            DoubleBinaryOperator plane = (column, row) -> -100 + gx * column + gy * row;
            double receiver = plane.applyAsDouble(x, y);
            double[] depths = new double[4];
            for (int texel = 0; texel < 4; texel++) {
                double column = Math.floor(x - 0.5) + 0.5 + (texel == 1 || texel == 2 ? 1 : 0);
                double row = Math.floor(y - 0.5) + 0.5 + (texel < 2 ? 1 : 0);
                depths[texel] = plane.applyAsDouble(column, row);
            }
            double[] nearerBy = ShadowFilter.nearerThanPlane(depths, receiver, gx, gy, four);
            assertArrayEquals(new double[4], nearerBy, 1e-12, "plane " + i);
            double slope = Math.abs(gx) + Math.abs(gy);
            assertEquals(1, ShadowFilter.litShare(nearerBy, four.weight(), HALF_TEXEL, slope), 1e-9, "plane " + i);
            assertEquals(1, ofMapped(nearerBy, four.weight(), slope), 1e-9, "plane " + i);
        }
    }

    /** The filter's distance of a plane, for a light at the origin along z, equals the exact one at any texel. */
    @Test
    void aPlaneIsItselfInALightsPicture() {
        double range = 40;
        Vec3 n = new Vec3(0.3, -0.2, -0.9);
        double texelsToTangent = 2.0 / 512;
        SplittableRandom random = new SplittableRandom(8);
        for (int i = 0; i < 1000; i++) {
            double x = random.nextDouble() * 512;
            double y = random.nextDouble() * 512;
            var four = ShadowFilter.Footprint.at(x, y);
            double[] depths = new double[4];
            for (int texel = 0; texel < 4; texel++) {
                depths[texel] = distance(n, texelsToTangent, x + four.dx()[texel], y + four.dy()[texel]) / range;
            }
            double[] nearerBy = ShadowFilter.nearerThanPlaneOfLight(
                    depths,
                    distance(n, texelsToTangent, x, y),
                    n.x() * texelsToTangent / -5,
                    n.y() * texelsToTangent / -5,
                    range,
                    four);
            assertArrayEquals(new double[4], nearerBy, 1e-12, "texel " + x + ", " + y);
        }
    }

    /** Returns the distance of the plane n · q = −5 at a texel. */
    private static double distance(Vec3 n, double texelsToTangent, double x, double y) {
        return -5 / (n.x() * (x - 256) * texelsToTangent + n.y() * (y - 256) * texelsToTangent + n.z());
    }

    @ParameterizedTest
    @CsvSource({"9.5, 0", "9.75, 0.25", "10, 0.5", "10.5, 1"})
    void anEdgeIsSharpWithinOneTexel(double x, double lit) {
        var four = ShadowFilter.Footprint.at(x, 5);
        int first = (int) Math.floor(x - 0.5);
        double[] nearerBy = IntStream.range(0, 4)
                .mapToDouble(i -> first + (i == 1 || i == 2 ? 1 : 0) < 10 ? 0.3 : 0)
                .toArray();
        assertEquals(lit, ShadowFilter.litShare(nearerBy, four.weight(), HALF_TEXEL, 0), 1e-12);
        assertEquals(lit, ofMapped(nearerBy, four.weight(), 0), 1e-12);
    }

    /** Surfaces far behind the room, mapped beyond the edge of a thin wall, do not make the receiver lit. */
    @Test
    void whatLiesBehindAReceiverProvesNoLight() {
        double[] nearerBy = {-3, -3, 0.2, 0.2};
        assertEquals(0.5, ShadowFilter.litShare(nearerBy, EVENLY, HALF_TEXEL, 0));
        assertEquals(0, ofMapped(nearerBy, EVENLY, 0));
    }

    /** The plane of a wall's inner face intersects the roof's sunlit side, which does not make the face lit. */
    @Test
    void anotherFaceInTheReceiversPlaneProvesNoLight() {
        boolean[] isLike = {false, false, true, true};
        double[] nearerBy = {0, 0, 0.5, 0.5};
        assertEquals(0.5, ofMapped(nearerBy, EVENLY, 0.1));
        assertEquals(0, ShadowFilter.litShareOfMapped(nearerBy, isLike, EVENLY, HALF_TEXEL, 0.1));
    }

    /** At a lit joint the other face is slightly nearer than the plane. */
    @Test
    void aFaceAtAJointShadesNothing() {
        assertEquals(1, ofMapped(new double[] {0.1, 0.1, 0, 0}, EVENLY, 0.2));
        double[] corner = {0.05, 0.45, 0.45, 0.05};
        assertEquals(0.05 / (0.05 + 0.1 * 0.95), ofMapped(new double[] {0, 0.1, 0.1, 0.1}, corner, 0.2), 1e-12);
        assertEquals(0, ofMapped(new double[] {0.1, 0.1, 0.1, 0.1}, EVENLY, 0.2), "nothing shows the receiver");
    }

    @Test
    void aFaceNarrowerThanATexelBeforeNothingIsLit() {
        assertEquals(1, ofMapped(new double[] {-1, -1, -1, -1}, EVENLY, 0.2));
    }

    /** The farthest caster shades what is behind it, however near to the end of depth it is; empty texels shade nothing. */
    @Test
    void aReceiverBeyondAllDepthIsShaded() {
        var four = ShadowFilter.Footprint.at(3, 5);
        double[] behindEdge = {1, 0.999, 0.999, 1};
        double[] nearerBy = ShadowFilter.nearerThanPlane(behindEdge, 40, 0.01, 0.02, four);
        assertEquals(0.5, ShadowFilter.litShare(nearerBy, EVENLY, HALF_TEXEL, 0.03), 1e-12);
        assertEquals(0.5, ofMapped(nearerBy, EVENLY, 0.03), 1e-12);
        double[] before = ShadowFilter.nearerThanPlane(behindEdge, -40, 0.01, 0.02, four);
        assertEquals(1, ShadowFilter.litShare(before, EVENLY, HALF_TEXEL, 0.03), 1e-12);
        assertEquals(1, ofMapped(before, EVENLY, 0.03), 1e-12);
    }

    @Test
    void theSixFacesOfAnUprightBoxDiffer() {
        long octants = IntStream.range(0, 6)
                .map(i -> {
                    int sign = i < 3 ? 1 : -1;
                    return ShadowFilter.octantOf(
                            new Vec3(i % 3 == 0 ? sign : 0, i % 3 == 1 ? sign : 0, i % 3 == 2 ? sign : 0));
                })
                .distinct()
                .count();
        assertEquals(6, octants);
    }

    /** Normals with small integer components, rounded to 16 bits, keep their octant. */
    @Test
    void noPlainSlopeLiesOnABorder() {
        for (int i = 0; i < 13 * 13 * 13; i++) {
            double x = i % 13 - 6;
            double y = i / 13 % 13 - 6;
            double z = i / 169 - 6;
            double length = Math.sqrt(x * x + y * y + z * z);
            if (length > 0) {
                var normal = new Vec3(x / length, y / length, z / length);
                for (int axis = 0; axis < 3; axis++) {
                    double shift = 5e-5;
                    var stored = new Vec3(
                            normal.x() + (axis == 0 ? shift : -shift),
                            normal.y() + (axis == 1 ? shift : -shift),
                            normal.z() + (axis == 2 ? shift : -shift));
                    assertEquals(ShadowFilter.octantOf(normal), ShadowFilter.octantOf(stored), () -> "" + normal);
                }
            }
        }
    }

    @Test
    void aDepthKeepsItsFacing() {
        SplittableRandom random = new SplittableRandom(3);
        for (int i = 0; i < 1000; i++) {
            float depth = (float) random.nextDouble();
            int octant = random.nextInt(8);
            float stored = ShadowFilter.depthWithOctant(depth, octant);
            assertEquals(depth, stored, 8 * Math.ulp(depth));
            assertTrue(ShadowFilter.looksLike(stored, octant));
            assertFalse(ShadowFilter.looksLike(stored, octant ^ 1));
        }
        assertTrue(ShadowFilter.looksLike(1, 5), "beyond all depth");
    }

    private static double ofMapped(double[] nearerBy, double[] weight, double slope) {
        return ShadowFilter.litShareOfMapped(nearerBy, ALL, weight, HALF_TEXEL, slope);
    }
}
