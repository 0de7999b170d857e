package nephele.lab.prove.sky;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import nephele.engine.atmosphere.Air;
import nephele.engine.atmosphere.AirTables;
import nephele.engine.atmosphere.SkyTable;
import nephele.engine.level.Environment;
import nephele.engine.level.Exposure;
import nephele.engine.level.Sky.Atmosphere;
import nephele.engine.level.Sun;
import nephele.engine.level.ToneCurve;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.level.appearance.Heavens;
import nephele.engine.math.Hash64;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.ToneMapping;
import nephele.lab.prove.proof.Claim;
import nephele.lab.prove.proof.Figure;
import nephele.lab.prove.proof.Proof;
import nephele.lab.prove.proof.ProofResult;

/**
 * Lets the sun climb from −10 to 90 degrees in steps of 0.01, a unit being {@value #STEPS} of them, and follows the clock
 * at random instants of a year at random latitudes, in as many of its steps. The dome has no disc, stars and moon.
 */
public final class SkySweepProof implements Proof {
    /** Steps of a unit. */
    static final int STEPS = 10;

    static final int SWEEP_UNITS = 1000;
    private static final int HOUR_UNITS = 200;
    private static final double LOWEST_DEGREES = -10;
    private static final double STEP_DEGREES = 0.01;
    private static final double MOST_CODES = 2;
    /** Exposures of noon and evening, then those of dusk and night. */
    private static final double[] LIT_STOPS = {-0.3, 1};

    private static final double[] DARK_STOPS = {4.5, 10};
    /**
     * Elevation of the sun below which the exposures of dusk and night count. At higher ones they overexpose most of the
     * sky, and show that the sun of the integration is a point, whose edge of shadow sweeps the lowest air in 0.1 degrees.
     */
    private static final double DARK_BELOW_SINE = Math.sin(Math.toRadians(-1));

    private static final double SOLAR_IRRADIANCE = 4;
    private static final double EYE_METRES = 2;
    private static final int RINGS = 16;
    private static final int AZIMUTHS = 12;
    private static final double DAY_SECONDS = 36_000;

    private final AirTables air = AirTables.of(Air.CLEAR);

    @Override
    public Claim claim() {
        return new Claim(
                "sky-sweep",
                "While the sun rises from −10 to 90 degrees in steps of 0.01, and at 200 instants of a year while the"
                        + " clock moves it by as much, no direction of sky and ground changes by more than 2 codes in"
                        + " a step, at the exposures of noon and evening, and with the sun below −1 degree at those of"
                        + " dusk and night; none is negative or"
                        + " not a number.",
                "stretches of ten steps",
                SWEEP_UNITS + HOUR_UNITS,
                40);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) {
        ProofResult result = ProofResult.NOTHING;
        for (long unit = from; unit < from + count; unit++) {
            result = result.and(unit < SWEEP_UNITS ? swept(unit) : timed(unit));
            progress.unitsDone(unit - from + 1);
        }
        return result;
    }

    private ProofResult swept(long unit) {
        Codes codes = new Codes("sun");
        for (int step = 0; step <= STEPS; step++) {
            double degrees = LOWEST_DEGREES + (unit * STEPS + step) * STEP_DEGREES;
            double angle = Math.toRadians(degrees);
            Vec3 towards = new Vec3(0, Math.sin(angle), -Math.cos(angle));
            codes.follow(degrees, at(new Atmosphere(0.3, 1, 0.8, 1, 45, 172, 12, 0), towards, 0));
        }
        return codes.result();
    }

    private ProofResult timed(long unit) {
        SplittableRandom random = new SplittableRandom(Hash64.combine(23, unit));
        Atmosphere sky = new Atmosphere(
                0.3,
                1,
                0.8,
                1,
                random.nextDouble(-90, 90),
                random.nextDouble(1, 366),
                24 * random.nextDouble(),
                DAY_SECONDS);
        Codes codes = new Codes("hour");
        for (int step = 0; step <= STEPS; step++) {
            codes.follow(step, at(sky, null, step + 0.5));
        }
        return codes.result();
    }

    private static Environment at(Atmosphere sky, Vec3 towards, double seconds) {
        Vec3 outside = new Vec3(SOLAR_IRRADIANCE, SOLAR_IRRADIANCE, SOLAR_IRRADIANCE);
        Sun sun = new Sun(towards, outside, true);
        Environment written = new Environment(sun, sky, null, Exposure.NEUTRAL, ToneCurve.CLIP, null, List.of());
        return Daylight.at(written, seconds);
    }

    /** Returns the radiance of the sky and of the planet's ground below it. */
    private double[] light(Environment now) {
        Vec3 towards = now.sun().directionTowardsSun();
        SkyTable table = new SkyTable(air, EYE_METRES, towards.y());
        double[] light = new double[3 * RINGS * AZIMUTHS];
        for (int i = 0; i < RINGS * AZIMUTHS; i++) {
            Vec3 direction = direction(i);
            Vec3 radiance = table.radiance(direction, towards)
                    .plus(Heavens.nightGlow((Atmosphere) now.sky(), towards.y(), direction.y()))
                    .scaled(SOLAR_IRRADIANCE);
            light[3 * i] = radiance.x();
            light[3 * i + 1] = radiance.y();
            light[3 * i + 2] = radiance.z();
        }
        return light;
    }

    /** Directions are densest at the horizon, which none of them meets. */
    private static Vec3 direction(int index) {
        double share = 2 * (index / AZIMUTHS + 0.5) / RINGS - 1;
        double elevation = Math.signum(share) * share * share * Math.PI / 2;
        double azimuth = 2 * Math.PI * (index % AZIMUTHS + 0.37) / AZIMUTHS;
        double level = Math.cos(elevation);
        return new Vec3(level * Math.sin(azimuth), Math.sin(elevation), -level * Math.cos(azimuth));
    }

    /** The codes of one stretch. */
    private final class Codes {
        private final String what;
        private final List<String> failures = new ArrayList<>();
        private double[] before;
        private double greatest;

        Codes(String what) {
            this.what = what;
        }

        void follow(double place, Environment now) {
            double[] light = light(now);
            boolean isDark = now.sun().directionTowardsSun().y() < DARK_BELOW_SINE;
            double[] stops = isDark ? DARK_STOPS : LIT_STOPS;
            for (int i = 0; i < light.length; i++) {
                if (!(light[i] >= 0 && light[i] < Double.POSITIVE_INFINITY)) {
                    fail(place, now, i, light[i] + " is no radiance");
                } else if (before != null) {
                    double jump = jump(before[i], light[i], stops);
                    greatest = Math.max(greatest, jump);
                    if (jump > MOST_CODES) {
                        fail(place, now, i, "jumps by " + jump + " codes");
                    }
                }
            }
            before = light;
        }

        private void fail(double place, Environment now, int index, String why) {
            failures.add(String.format(
                    Locale.ROOT, "%s %.2f, %s, direction %d: %s", what, place, now.sky(), index / 3, why));
        }

        ProofResult result() {
            return ProofResult.of(
                    1,
                    failures,
                    Figure.sum("steps", STEPS, ""),
                    Figure.greatest("greatest change in a step", greatest, "codes"));
        }
    }

    private static double jump(double from, double to, double[] exposures) {
        double greatest = 0;
        for (double stops : exposures) {
            double exposure = Math.pow(2, stops);
            greatest = Math.max(greatest, Math.abs(code(to * exposure) - code(from * exposure)));
        }
        return greatest;
    }

    private static double code(double linear) {
        return 255 * ToneMapping.displayValue(linear, 1, ToneCurve.CLIP);
    }
}
