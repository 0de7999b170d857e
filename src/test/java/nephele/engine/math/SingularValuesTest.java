package nephele.engine.math;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.joml.Matrix3d;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SingularValuesTest {
    private static Matrix4d turned(Random random, Vector3d scale) {
        return new Matrix4d()
                .translate(random.nextGaussian(), 7, -3)
                .rotate(random.nextDouble() * 7, new Vector3d(random.nextGaussian(), 1, 2).normalize())
                .scale(scale)
                .rotate(random.nextDouble() * 7, new Vector3d(1, random.nextGaussian(), 2).normalize());
    }

    @Test
    void itIsTheLargestOfThreeScalesHoweverTurned() {
        Random random = new Random(31);
        for (int i = 0; i < 2000; i++) {
            double size = Math.pow(10, random.nextInt(7) - 3);
            double second = i % 3 == 0 ? 1 : i % 3 == 1 ? -1 + 1e-9 : random.nextDouble() * 2 - 1;
            Vector3d scale = new Vector3d(size, size * second, size * (random.nextDouble() * 2 - 1));
            // JOML's cosines are accurate to half the digits only.
            assertEquals(1, SingularValues.maximum(turned(random, scale)) / size, 1e-7);
        }
    }

    /**
     * No direction is stretched more, and one is stretched as much; checked by power iteration with repeated squaring.
     */
    @Test
    void itBoundsEveryDirectionAndIsReached() {
        Random random = new Random(77);
        for (int i = 0; i < 2000; i++) {
            Matrix4d m = new Matrix4d();
            for (int column = 0; column < 3; column++) {
                for (int row = 0; row < 3; row++) {
                    m.set(column, row, random.nextGaussian() * Math.pow(10, random.nextInt(4)));
                }
            }
            double stretch = SingularValues.maximum(m);
            Matrix3d power = m.get3x3(new Matrix3d()).transpose().mul(m.get3x3(new Matrix3d()));
            double trace = power.m00 + power.m11 + power.m22;
            power.scale(1 / trace);
            for (int squaring = 0; squaring < 40; squaring++) {
                power.mul(new Matrix3d(power));
                power.scale(1 / (power.m00 + power.m11 + power.m22));
            }
            Vector3d direction = power.transform(new Vector3d(0.3, 0.5, 0.7)).normalize();
            assertEquals(stretch, m.transformDirection(direction).length(), stretch * 1e-9);
            for (int k = 0; k < 20; k++) {
                direction
                        .set(random.nextGaussian(), random.nextGaussian(), random.nextGaussian())
                        .normalize();
                assertTrue(m.transformDirection(direction).length() <= stretch * (1 + 1e-13));
            }
        }
    }

    @Test
    void ofTwoEqualLargestScalesNoDigitIsLost() {
        Matrix4d shear = new Matrix4d();
        shear.m10(1e-8);
        // The singular values of [[1, s], [0, 1]] are √(1 + s²/4) ± s/2.
        assertEquals(1 + 0.5e-8, SingularValues.maximum(shear), 1e-15);
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-300, 1e-160, 1e160, 1e300})
    void neitherSquaresNorTheirRootsOverflowOrVanish(double size) {
        Matrix4d m = new Matrix4d();
        m.m00(size).m11(-2 * size).m22(size);
        assertEquals(2, SingularValues.maximum(m) / size, 1e-15);
    }

    @Test
    void nothingIsNoStretchAndWhatIsNoNumberStaysSo() {
        assertEquals(0, SingularValues.maximum(new Matrix4d().scaling(0)));
        assertTrue(Double.isNaN(SingularValues.maximum(new Matrix4d().m11(Double.NaN))));
        assertTrue(Double.isNaN(SingularValues.maximum(new Matrix4d().m11(Double.POSITIVE_INFINITY))));
    }
}
