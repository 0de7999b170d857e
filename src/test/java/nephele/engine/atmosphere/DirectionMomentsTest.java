package nephele.engine.atmosphere;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

@Execution(ExecutionMode.CONCURRENT)
class DirectionMomentsTest {
    private static final int DEGREE = 8;

    /** Legendre's addition theorem, averaged over a direction and its mirror image. */
    @Test
    void theSumOverOrdersIsTheLegendrePolynomialOfTheAngleBetween() {
        DirectionMoments moments = new DirectionMoments(DEGREE);
        double[] a = new double[DirectionMoments.count(DEGREE)];
        double[] b = new double[a.length];
        for (double mu : new double[] {-1, -0.6, 0, 0.2, 0.99, 1}) {
            for (double nu : new double[] {-0.9, 0.1, 0.7}) {
                for (double azimuth : new double[] {0, 1, 2.5, Math.PI}) {
                    moments.put(mu, Math.cos(azimuth), a);
                    moments.put(nu, Math.cos(0.7), b);
                    for (int l = 0; l <= DEGREE; l++) {
                        double sum = 0;
                        for (int m = 0; m <= l; m++) {
                            sum += a[DirectionMoments.index(l, m)] * b[DirectionMoments.index(l, m)];
                        }
                        double expected = (legendre(l, between(mu, nu, azimuth - 0.7))
                                        + legendre(l, between(mu, nu, azimuth + 0.7)))
                                / 2;
                        assertEquals((2 * l + 1) / (4 * Math.PI) * expected, sum, 1e-12);
                    }
                }
            }
        }
    }

    private static double between(double mu, double nu, double azimuth) {
        return mu * nu + Math.sqrt((1 - mu * mu) * (1 - nu * nu)) * Math.cos(azimuth);
    }

    private static double legendre(int degree, double x) {
        double before = 0;
        double now = 1;
        for (int l = 0; l < degree; l++) {
            double next = ((2 * l + 1) * x * now - l * before) / (l + 1);
            before = now;
            now = next;
        }
        return now;
    }
}
