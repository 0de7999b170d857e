package nephele.engine.level.appearance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
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
class CelestialPositionsTest {
    private static Atmosphere sky(double latitude, double day, double hours, double dayLength) {
        return new Atmosphere(0.3, 1, 0.8, 1, latitude, day, hours, dayLength, 0.2666);
    }

    private static Environment under(Atmosphere sky) {
        return new TestLevel().sky(sky).level().environment();
    }

    /** At noon the height of the sun is 90° − latitude + declination. */
    @ParameterizedTest
    @CsvSource({"0, 80, 90", "45, 80, 45", "45, 171.3, 68.44", "45, 354, 21.56", "-30, 354, 83.44", "66.56, 354, 0"})
    void theNoonSunIsAsHighAsTheSeasonHasIt(double latitude, double day, double degrees) {
        Vec3 sun = CelestialPositions.towardsSun(sky(latitude, day - 0.5, 12, 0));
        assertEquals(degrees, Math.toDegrees(Math.asin(sun.y())), 0.2);
        assertEquals(0, sun.x(), 1e-9, "it stands in the meridian");
        assertEquals(1, sun.dot(sun), 1e-12);
    }

    @Test
    void theSunRisesInTheEastAndSetsInTheWest() {
        assertTrue(CelestialPositions.towardsSun(sky(45, 80, 7, 0)).x() > 0.9);
        assertTrue(CelestialPositions.towardsSun(sky(45, 80, 17, 0)).x() < -0.9);
        assertTrue(CelestialPositions.towardsSun(sky(45, 80, 12, 0)).z() > 0, "noon is in the south");
        assertTrue(CelestialPositions.towardsSun(sky(45, 80, 0, 0)).y() < 0);
    }

    @Test
    void aYearInSmallStepsMovesTheSunInSmallSteps() {
        Atmosphere sky = sky(51, 1, 0, 36_000);
        for (int day = 0; day < 366; day += 61) {
            Vec3 before = CelestialPositions.towardsSun(CelestialPositions.later(sky, 36_000 * day + 0.5));
            for (int i = 1; i < 36_000; i++) {
                Vec3 now = CelestialPositions.towardsSun(CelestialPositions.later(sky, 36_000 * day + i + 0.5));
                double moved = Math.toDegrees(now.minus(before).length());
                assertTrue(moved <= 0.0101, "day " + day + " step " + i);
                before = now;
            }
        }
    }

    @Test
    void aDayLaterTheSunIsWhereItWasAndTheMoonTwelveDegreesBehind() {
        Atmosphere sky = sky(45, 80, 9, 600);
        Atmosphere tomorrow = CelestialPositions.later(sky, 600);
        assertEquals(1, CelestialPositions.days(sky, 600), 1e-4);
        Vec3 today = CelestialPositions.towardsSun(sky);
        assertTrue(Math.toDegrees(
                        CelestialPositions.towardsSun(tomorrow).minus(today).length())
                < 0.5);
        double moved = CelestialPositions.towardsMoon(tomorrow).dot(CelestialPositions.towardsMoon(sky));
        assertEquals(12.2, Math.toDegrees(Math.acos(moved)), 2);
    }

    /** Four years are a whole number of days; a float clock of seconds would be 0.25 s off after 30 days. */
    @Test
    void afterThirtyDaysOfPlayTheSunStandsAsFourYearsBefore() {
        Atmosphere sky = sky(45, 80, 9, 600);
        double fourYears = 1461 * 600.0;
        for (double seconds : new double[] {0, 0.3, 7.77, 321.5}) {
            Vec3 before = CelestialPositions.towardsSun(CelestialPositions.later(sky, seconds));
            Vec3 after = CelestialPositions.towardsSun(CelestialPositions.later(sky, seconds + 3 * fourYears));
            assertTrue(Math.toDegrees(after.minus(before).length()) <= 0.0101, seconds + " s");
        }
    }

    @Test
    void theSkyOfAnInstantHasItsHour() {
        Environment later = Daylight.at(under(sky(45, 80, 23, 240)), 20);
        Atmosphere then = (Atmosphere) later.sky();
        assertEquals(81, then.dayOfYear(), "past midnight");
        assertEquals(1, then.timeOfDayHours(), 1e-3);
        Environment again = Daylight.at(later, 0);
        assertSame(later, again, "the hour's sun is recognised");
        Environment first = Daylight.at(under(sky(45, 80, 23, 240)), 0);
        assertEquals(later, Daylight.at(first, 20), "the sun of the level's first hour moves on");
    }

    @Test
    void theNewMoonIsAtTheSunAndTheFullMoonOpposite() {
        for (double latitude : new double[] {-40, 0, 60}) {
            Atmosphere young = sky(latitude, 6 - 0.25, 6, 0);
            assertEquals(1, CelestialPositions.towardsMoon(young).dot(CelestialPositions.towardsSun(young)), 1e-6);
            Atmosphere full = sky(latitude, 6 - 0.25 + 29.530588 / 2, 6, 0);
            assertTrue(CelestialPositions.towardsMoon(full).dot(CelestialPositions.towardsSun(full)) < -0.99);
        }
    }

    @Test
    void theAxesOfTheStarsAreARightHandedBasisAroundThePole() {
        Vec3[] axes = CelestialPositions.celestialAxes(sky(50, 200, 10.2, 0));
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
        assertSame(written, Daylight.at(written, 0));
        assertSame(written.sun(), Daylight.at(written, 100).sun());
        Environment timed = Daylight.at(under(sky(45, 80, 9, 60)), 0);
        assertNotNull(timed.sun());
        assertEquals(timed, Daylight.at(under(sky(45, 80, 9, 60)), 60 / 36_000.0 / 2), "within a step");
        assertTrue(Daylight.moves(under(sky(45, 80, 9, 60))) && !Daylight.moves(under(sky(45, 80, 9, 0))));
    }

    @Test
    void aSunWithoutADirectionStandsWhereTheHourPutsIt() {
        Sun bright = new Sun(null, new Vec3(7, 6, 5), false);
        Environment written = under(sky(45, 80, 9, 60)).with(bright);
        Sun sun = Daylight.at(written, 20).sun();
        assertEquals(Daylight.at(under(sky(45, 80, 17, 60)), 0).sun().directionTowardsSun(), sun.directionTowardsSun());
        assertEquals(bright.irradiance(), sun.irradiance());
        assertFalse(sun.castsShadow());
        assertNull(
                Daylight.at(new TestLevel().level().environment().with(bright), 0)
                        .sun(),
                "nobody says where");
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
