package nephele.engine.reference.sky;

import static org.junit.jupiter.api.Assertions.assertEquals;

import nephele.engine.level.Sky;
import nephele.engine.level.Sun;
import nephele.engine.level.TestLevel;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SunDiscTest {
    private static final Sky.Atmosphere SKY = new Sky.Atmosphere(0.3, 1, 0.8, 1, 45, 172, 12, 0, 0.2666);

    /** What a surface receives from the disc is what the sun as a direction gives it. */
    @ParameterizedTest
    @ValueSource(doubles = {85, 40, 10, 3, 1})
    void itsIrradianceIsThatOfTheSun(double elevationDegrees) {
        double elevation = Math.toRadians(elevationDegrees);
        Vec3 towards = new Vec3(Math.cos(elevation), Math.sin(elevation), 0);
        Sun sun = new Sun(towards, new Vec3(4, 5, 6), true);
        SunDisc disc = SunDisc.of(new TestLevel().sky(SKY).level().environment().with(sun))
                .orElseThrow();
        Vec3 across = Directions.perpendicular(towards);
        Vec3 up = towards.cross(across);
        int rings = 100;
        int sectors = 60;
        Vec3 sum = Vec3.ZERO;
        for (int ring = 0; ring < rings; ring++) {
            double radius = disc.radiusRadians() * Math.sqrt((ring + 0.5) / rings);
            for (int sector = 0; sector < sectors; sector++) {
                double angle = 2 * Math.PI * sector / sectors;
                Vec3 off = Directions.combined(across, radius * Math.cos(angle), up, radius * Math.sin(angle));
                sum = sum.plus(disc.towards(Directions.unit(towards.plus(off)), 0));
            }
        }
        double steradians = Math.PI * disc.radiusRadians() * disc.radiusRadians() / (rings * sectors);
        Vec3 wanted = sun.irradiance().times(Daylight.air(SKY).sunlight(0, towards.y()));
        assertEquals(wanted.x(), sum.x() * steradians, 0.005 * wanted.x());
        assertEquals(wanted.y(), sum.y() * steradians, 0.005 * wanted.y());
        assertEquals(wanted.z(), sum.z() * steradians, 0.005 * wanted.z());
    }
}
