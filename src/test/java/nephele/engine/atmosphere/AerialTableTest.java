package nephele.engine.atmosphere;

import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.math.Vec3;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

@Execution(ExecutionMode.CONCURRENT)
class AerialTableTest {
    private static final AirTables CLEAR = AirTables.of(Air.CLEAR);
    private static final int DIRECTIONS = 60;
    private static final double[] METRES = {10, 100, 1_000, 5_000, 20_000, 100_000};
    private static final double GOLDEN_ANGLE = Math.PI * (3 - Math.sqrt(5));
    /** Less than a pixel. At the very horizon the light of a sun at the horizon changes within less than that. */
    private static final double HORIZON_RADIANS = Math.toRadians(0.05);

    /** Half of the directions are dense at the horizon. */
    private static Vec3 direction(int i) {
        double even = 1 - 2 * (i + 0.5) / DIRECTIONS;
        double y = i % 2 == 0 ? even : even * even * even;
        double radius = Math.sqrt(1 - y * y);
        return new Vec3(radius * Math.cos(i * GOLDEN_ANGLE), y, radius * Math.sin(i * GOLDEN_ANGLE));
    }

    private static double[] numbers(Vec3 v) {
        return new double[] {v.x(), v.y(), v.z()};
    }

    /** Returns the distance at which a ray meets the planet, which hides what is behind. */
    private static double toGround(double height, double sine) {
        double radius = Air.PLANET_RADIUS_METRES + height;
        double square = radius * sine * radius * sine - height * (2 * Air.PLANET_RADIUS_METRES + height);
        return sine < 0 && square >= 0 ? -radius * sine - Math.sqrt(square) : Double.POSITIVE_INFINITY;
    }

    private static boolean isJudged(double height, Vec3 direction, double metres) {
        double elevation = Math.asin(direction.y());
        return metres <= toGround(height, direction.y()) + 20
                && Math.abs(elevation) > HORIZON_RADIANS
                && Math.abs(elevation - SkyTable.horizonRadians(height)) > HORIZON_RADIANS;
    }

    /**
     * Every radiance is within 5 % of itself + 0.5 % of the dome's mean, every transmittance within 5 % of itself +
     * 0.005; at 100 km from eyes in or above the ozone, and at the edge of the planet's shadow in the high air, within
     * the given multiple of that.
     */
    @ParameterizedTest
    @CsvSource({
        "0, 90, 1",
        "2, 10, 1",
        "2, 0, 1",
        "2, -2, 1",
        "2, -6, 2",
        "2, -10, 1",
        "1500, 5, 1",
        "10000, -5, 4",
        "35000, 3, 2",
        "80000, 60, 2"
    })
    void theTableFollowsTheIntegration(double height, double sunDegrees, double mostAt100Kilometres) {
        double sunRadians = Math.toRadians(sunDegrees);
        Vec3 sun = new Vec3(0, Math.sin(sunRadians), -Math.cos(sunRadians));
        AerialTable table = new AerialTable(CLEAR, height, sun.y());
        ClearSky sky = new ClearSky(CLEAR);
        double mean = 0;
        for (int i = 0; i < DIRECTIONS; i += 2) {
            Vec3 light = sky.radiance(height, direction(i), sun);
            mean += (light.x() + light.y() + light.z()) / 3 / (DIRECTIONS / 2);
        }
        for (int i = 0; i < DIRECTIONS; i++) {
            for (double metres : METRES) {
                if (isJudged(height, direction(i), metres)) {
                    AirLight exact = sky.along(height, direction(i), sun, metres);
                    AirLight found = table.along(direction(i), sun, metres);
                    double most = metres < 100_000 ? 1 : mostAt100Kilometres;
                    String where = direction(i) + ", " + metres + " m";
                    assertNear(exact.radiance(), found.radiance(), most, mean, where);
                    assertNear(exact.transmittance(), found.transmittance(), most, 1, where);
                }
            }
        }
    }

    private static void assertNear(Vec3 exact, Vec3 found, double most, double mean, String where) {
        for (int c = 0; c < Air.CHANNELS; c++) {
            double wanted = numbers(exact)[c];
            double error = Math.abs(numbers(found)[c] - wanted);
            assertTrue(error <= most * (0.05 * wanted + 0.005 * mean), where + ": " + error + " of " + wanted);
        }
    }
}
