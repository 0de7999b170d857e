package nephele.engine.reference.sky;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import java.util.SplittableRandom;
import nephele.engine.level.Environment;
import nephele.engine.level.Sky;
import nephele.engine.level.Sun;
import nephele.engine.level.TestLevel;
import nephele.engine.level.appearance.ColourDecoding;
import nephele.engine.level.appearance.SkyRadiance;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SkyOfPathsTest {
    private static final Sky.Atmosphere SKY = new Sky.Atmosphere(0.3, 1, 0.8, 1, 45, 172, 12, 0, 0.2666);
    private static final int DIRECTIONS = 3000;

    /** The light of all directions is that of the integration, with little noise. */
    @ParameterizedTest
    @CsvSource({"50, 0", "4, 1800", "-8, 20"})
    void itsMeanIsTheIntegration(double elevationDegrees, double height) {
        double elevation = Math.toRadians(elevationDegrees);
        Sun sun = new Sun(new Vec3(Math.cos(elevation), Math.sin(elevation), 0), TestLevel.grey(1), true);
        Environment environment = new TestLevel().sky(SKY).level().environment().with(sun);
        Optional<SkyRadiance> exact = SkyRadiance.of(environment, id -> null, ColourDecoding.SRGB);
        SkyOfPaths sky = SkyOfPaths.of(environment, exact).orElseThrow();
        SplittableRandom random = new SplittableRandom(3);
        double wanted = 0;
        double off = 0;
        double squares = 0;
        for (int i = 0; i < DIRECTIONS; i++) {
            double y = 2 * random.nextDouble() - 1;
            double angle = 2 * Math.PI * random.nextDouble();
            double flat = Math.sqrt(1 - y * y);
            Vec3 from = new Vec3(flat * Math.cos(angle), y, flat * Math.sin(angle));
            Vector3d radiance = exact.orElseThrow().from(height, from.x(), from.y(), from.z());
            double difference = sky.radiance(height, from, random).y - radiance.y;
            wanted += radiance.y;
            off += difference;
            squares += difference * difference;
        }
        assertEquals(0, off, 4 * Math.sqrt(squares));
        assertTrue(Math.sqrt(squares) < 0.002 * wanted, Math.sqrt(squares) / wanted + " of the light");
    }
}
