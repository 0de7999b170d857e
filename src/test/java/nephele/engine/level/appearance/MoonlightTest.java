package nephele.engine.level.appearance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.engine.level.Environment;
import nephele.engine.level.Sky.Atmosphere;
import nephele.engine.level.Sun;
import nephele.engine.level.TestLevel;
import nephele.engine.math.Vec3;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

@Execution(ExecutionMode.CONCURRENT)
class MoonlightTest {
    private static final double FULL_MOON_DAY = 20;

    private static Environment at(double day, double hours) {
        Atmosphere sky = new Atmosphere(0.3, 1, 0.8, 1, 45, day, hours, 0, 0.2666);
        return Daylight.at(new TestLevel().sky(sky).level().environment(), 0);
    }

    /** The full moon gives 0.25 lux, the sun 128 000; the half moon a tenth of it. */
    @Test
    void theFullMoonIsAsBrightAsInNatureTimesTheGain() {
        Environment night = at(FULL_MOON_DAY, 23.5);
        Moonlight moon = Moonlight.of((Atmosphere) night.sky(), night.sun());
        double asInNature = moon.irradiance().y() / Moonlight.NIGHT_GAIN;
        assertEquals(0.25 / 128_000, asInNature, 0.3 * 0.25 / 128_000);
        assertEquals(1, Moonlight.phase(-1));
        assertEquals(0.09, Moonlight.phase(0), 0.01);
        assertTrue(Moonlight.phase(1) < 1e-3);
    }

    @Test
    void atNightTheMoonIsInTheSunsPlace() {
        Environment night = at(FULL_MOON_DAY, 23.5);
        Sun light = Daylight.onGround(night);
        assertEquals(CelestialPositions.towardsMoon((Atmosphere) night.sky()), light.directionTowardsSun());
        assertTrue(light.irradiance().x() > light.irradiance().z(), "the air reddens it");
        Environment dark = at(FULL_MOON_DAY + 15, 23.5);
        assertEquals(Vec3.ZERO, Daylight.onGround(dark).irradiance(), "the new moon is with the sun");
    }

    /** Both lights are zero where one takes the place of the other, and nothing jumps on the way. */
    @Test
    void theHandOverFromSunToMoonIsSteady() {
        for (double day : new double[] {FULL_MOON_DAY - 4, FULL_MOON_DAY, FULL_MOON_DAY + 4}) {
            Sun before = Daylight.onGround(at(day, 0));
            for (int step = 1; step <= 7200; step++) {
                Sun now = Daylight.onGround(at(day, step / 300.0));
                double change =
                        Math.abs(now.irradiance().y() - before.irradiance().y());
                double turn = now.directionTowardsSun()
                        .minus(before.directionTowardsSun())
                        .length();
                assertTrue(change < 0.04, "step " + step + " changes by " + change);
                boolean isDark =
                        before.irradiance().y() < 1e-5 || now.irradiance().y() < 1e-5;
                assertTrue(turn < 0.001 || isDark, "day " + day + " step " + step + " turns by " + turn);
                before = now;
            }
        }
    }
}
