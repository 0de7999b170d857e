package nephele.engine.cloud.cells;

import static org.junit.jupiter.api.Assertions.assertEquals;

import nephele.engine.cloud.ExactSlant;
import nephele.engine.math.Aabb;
import nephele.engine.math.Ray;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A ray meets a layer where it does around a sphere. */
class StackSpanTest {
    private static final double R = 6_360_000;

    @ParameterizedTest
    @CsvSource({
        "1.7, 90",
        "1.7, 30",
        "1.7, 3",
        "1.7, 0.3",
        "1.7, 0",
        "0, 0",
        "1400, 0.3",
        "1499.5, 0.3",
        "1499.999, 0",
        "0.5, 0.3"
    })
    void theSlantIsThatAroundASphere(double eye, double degrees) {
        double sine = Math.sin(Math.toRadians(degrees));
        Ray ray = new Ray(
                0, eye, 0, 0.6 * Math.cos(Math.toRadians(degrees)), sine, 0.8 * Math.cos(Math.toRadians(degrees)));
        StackSpan span = StackSpan.of(new Aabb(-1e6, 1500, -1e6, 1e6, 1800, 1e6), R, ray);
        assertEquals(ExactSlant.metres(eye, sine, 1500), span.fromMetres(), 1e-5);
        assertEquals(ExactSlant.metres(eye, sine, 1800), span.toMetres(), 1e-5);
        assertEquals(1500, StackSpan.height(R, ray, span.fromMetres()), 0.01);
        assertEquals(1800, StackSpan.height(R, ray, span.toMetres()), 0.01);
    }

    /** The sides of a box cut the span along both axes. */
    @ParameterizedTest
    @CsvSource({"1, 0", "0, 1"})
    void theSidesOfTheBoxCutTheSpan(double x, double z) {
        Ray ray = new Ray(-100 * x, 1600, -100 * z, x, 0, z);
        Aabb box = new Aabb(-30 - 1e3 * z, 1500, -30 - 1e3 * x, 40 + 1e3 * z, 1800, 40 + 1e3 * x);
        StackSpan span = StackSpan.of(box, R, ray);
        assertEquals(70, span.fromMetres(), 1e-9);
        assertEquals(140, span.toMetres(), 1e-9);
    }
}
