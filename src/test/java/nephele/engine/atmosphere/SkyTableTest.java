package nephele.engine.atmosphere;

import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.math.Vec3;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SkyTableTest {
    private static final AirTables CLEAR = AirTables.of(Air.CLEAR);
    private static final int DIRECTIONS = 700;
    private static final double GOLDEN_ANGLE = Math.PI * (3 - Math.sqrt(5));

    private static Vec3 direction(int i) {
        double y = 1 - 2 * (i + 0.5) / DIRECTIONS;
        double radius = Math.sqrt(1 - y * y);
        return new Vec3(radius * Math.cos(i * GOLDEN_ANGLE), y, radius * Math.sin(i * GOLDEN_ANGLE));
    }

    private static Vec3 sun(double degrees) {
        return new Vec3(0, Math.sin(Math.toRadians(degrees)), -Math.cos(Math.toRadians(degrees)));
    }

    private static double luminance(Vec3 rgb) {
        return 0.2126 * rgb.x() + 0.7152 * rgb.y() + 0.0722 * rgb.z();
    }

    @ParameterizedTest
    @CsvSource({
        "0, 90",
        "2, 40",
        "2, 10",
        "2, 1",
        "2, 0",
        "2, -2",
        "2, -6",
        "2, -10",
        "1500, 5",
        "10000, 30",
        "10000, 0",
        "10000, -5",
        "35000, 3",
        "35000, -4",
        "80000, 60",
        "80000, 0",
        "38000, -8",
        "80000, -6",
        "80000, -8"
    })
    void theTableFollowsTheIntegrationOverTheWholeDome(double height, double sunDegrees) {
        Vec3 sun = sun(sunDegrees);
        SkyTable table = new SkyTable(CLEAR, height, sun.y());
        ClearSky sky = new ClearSky(CLEAR);
        double[] exact = new double[DIRECTIONS];
        double mean = 0;
        for (int i = 0; i < DIRECTIONS; i++) {
            exact[i] = luminance(sky.radiance(height, direction(i), sun));
            mean += exact[i] / DIRECTIONS;
        }
        double squares = 0;
        for (int i = 0; i < DIRECTIONS; i++) {
            double error = Math.abs(luminance(table.radiance(direction(i), sun)) - exact[i]);
            squares += error * error / DIRECTIONS;
            assertTrue(error <= 0.05 * exact[i] + 0.005 * mean, direction(i) + ": " + error + " of " + exact[i]);
        }
        double rmse = Math.sqrt(squares) / mean;
        assertTrue(rmse <= 0.01, "luminance RMSE " + rmse);
    }
}
