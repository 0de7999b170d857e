package nephele.engine.level.appearance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.level.Environment;
import nephele.engine.level.Sky.Atmosphere;
import nephele.engine.level.Sun;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

@Execution(ExecutionMode.CONCURRENT)
class HeavensTest {
    private static Atmosphere sky(double latitude, double day, double hours, double dayLength) {
        return new Atmosphere(0.3, 1, 0.8, 1, latitude, day, hours, dayLength);
    }

    private static Environment under(Atmosphere sky) {
        return new TestLevel().sky(sky).level().environment();
    }

    /** At noon the height of the sun is 90° − latitude + declination. */
    @ParameterizedTest
    @CsvSource({"0, 80, 90", "45, 80, 45", "45, 171.3, 68.44", "45, 354, 21.56", "-30, 354, 83.44", "66.56, 354, 0"})
    void theNoonSunIsAsHighAsTheSeasonHasIt(double latitude, double day, double degrees) {
        Vec3 sun = Heavens.towardsSun(sky(latitude, day - 0.5, 12, 0), 0);
        assertEquals(degrees, Math.toDegrees(Math.asin(sun.y())), 0.2);
        assertEquals(0, sun.x(), 1e-9, "it stands in the meridian");
        assertEquals(1, sun.dot(sun), 1e-12);
    }

    @Test
    void theSunRisesInTheEastAndSetsInTheWest() {
        assertTrue(Heavens.towardsSun(sky(45, 80, 7, 0), 0).x() > 0.9);
        assertTrue(Heavens.towardsSun(sky(45, 80, 17, 0), 0).x() < -0.9);
        assertTrue(Heavens.towardsSun(sky(45, 80, 12, 0), 0).z() > 0, "noon is in the south");
        assertTrue(Heavens.towardsSun(sky(45, 80, 0, 0), 0).y() < 0);
    }

    @Test
    void aYearInSmallStepsMovesTheSunInSmallSteps() {
        Atmosphere sky = sky(51, 1, 0, 0);
        Vec3 before = Heavens.towardsSun(sky, 0);
        for (int i = 1; i < 40_000; i++) {
            Vec3 now = Heavens.towardsSun(sky, i / 36_000.0 + i / 40_000 * 100);
            assertTrue(Math.toDegrees(now.minus(before).length()) <= 0.0101, "step " + i);
            before = now;
        }
    }

    @Test
    void aDayLaterTheSunIsWhereItWasAndTheMoonTwelveDegreesBehind() {
        Atmosphere sky = sky(45, 80, 9, 600);
        assertEquals(1, Heavens.days(sky, 600), 1e-4);
        Vec3 today = Heavens.towardsSun(sky, 0);
        assertTrue(Math.toDegrees(Heavens.towardsSun(sky, 1).minus(today).length()) < 0.5);
        double moved = Heavens.towardsMoon(sky, 1).dot(Heavens.towardsMoon(sky, 0));
        assertEquals(12.2, Math.toDegrees(Math.acos(moved)), 2);
    }

    @Test
    void theNewMoonIsAtTheSunAndTheFullMoonOpposite() {
        for (double latitude : new double[] {-40, 0, 60}) {
            Atmosphere young = sky(latitude, 6 - 0.25, 6, 0);
            assertEquals(1, Heavens.towardsMoon(young, 0).dot(Heavens.towardsSun(young, 0)), 1e-6);
            Atmosphere full = sky(latitude, 6 - 0.25 + 29.530588 / 2, 6, 0);
            assertTrue(Heavens.towardsMoon(full, 0).dot(Heavens.towardsSun(full, 0)) < -0.99);
        }
    }

    @Test
    void theAxesOfTheStarsAreARightHandedBasisAroundThePole() {
        Vec3[] axes = Heavens.celestialAxes(sky(50, 200, 3, 0), 0.3);
        assertEquals(0, axes[0].cross(axes[1]).minus(axes[2]).length(), 1e-9);
        assertEquals(Math.sin(Math.toRadians(50)), axes[2].y(), 1e-9);
        assertTrue(axes[2].z() < 0, "the pole is in the north");
    }

    @Test
    void aWrittenSunWinsOverTheHour() {
        Environment written = new TestLevel()
                .sky(sky(45, 80, 9, 60))
                .sun(new Vec3(0, 1, 0), 3)
                .level()
                .environment();
        assertSame(written, Daylight.at(written, 100));
        Environment timed = Daylight.at(under(sky(45, 80, 9, 60)), 0);
        assertNotNull(timed.sun());
        assertEquals(timed, Daylight.at(under(sky(45, 80, 9, 60)), 60 / 36_000.0 / 2), "within a step");
        assertTrue(Daylight.moves(under(sky(45, 80, 9, 60))) && !Daylight.moves(under(sky(45, 80, 9, 0))));
    }

    @Test
    void theAirDimsTheLowSunAndTheHorizonHidesIt() {
        double[] degrees = {90, 20, 5, 1, 0.2, 0, -0.2, -0.27};
        double before = Double.POSITIVE_INFINITY;
        for (double degree : degrees) {
            double angle = Math.toRadians(degree);
            Environment environment = new TestLevel()
                    .sky(Atmosphere.CLEAR)
                    .sun(new Vec3(0, Math.sin(angle), -Math.cos(angle)), 1)
                    .level()
                    .environment();
            Sun sun = Daylight.onGround(environment);
            assertTrue(sun.irradiance().y() < before, degree + " degrees");
            assertTrue(degree < -0.26 || sun.irradiance().x() > sun.irradiance().z(), "it is yellow to red");
            before = sun.irradiance().y();
        }
        assertEquals(0, before);
    }
}
