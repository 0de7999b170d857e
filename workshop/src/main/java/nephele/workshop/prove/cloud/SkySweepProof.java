package nephele.workshop.prove.cloud;

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
import nephele.engine.level.appearance.CelestialPositions;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.math.Hash64;
import nephele.engine.math.Vec3;
import nephele.engine.render.frame.ToneMapping;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/**
 * Lets the sun climb from −10 to {@value #SWEPT_TO} degrees in steps of 0.01, a unit being {@value #STEPS} of them; takes
 * one such step in each degree above; and follows the clock by one at random instants of a year at random latitudes. The
 * dome has no disc, stars and moon.
 */
public final class SkySweepProof implements Proof {
    /** Steps of a unit of the sweep. */
    static final int STEPS = 10;

    private static final int SWEPT_TO = 22;
    static final int SWEEP_UNITS = 320;
    private static final int HIGH_UNITS = 90 - SWEPT_TO;
    private static final int HOUR_UNITS = 200;
    private static final double LOWEST_DEGREES = -10;
    private static final double STEP_DEGREES = 0.01;
    private static final double MOST_CODES = 2;

    /**
     * Elevations of the sun and the stops that {@code "auto"} has there for an eye that looks away from it, where the
     * longest exposure is called for, but 2 while the sun sets; at higher elevations every exposure counts.
     */
    private static final double[] DEGREES = {-10, -8, -6, -4, -2, -1, -0.6, -0.45, 0.1};

    private static final double[] AUTO_STOPS = {12, 11.1, 9.8, 8.1, 5.4, 4.2, 3.5, 2, 2};

    private static final double SOLAR_IRRADIANCE = 4;
    private static final double EYE_METRES = 2;
    private static final int RINGS = 16;
    private static final int AZIMUTHS = 12;
    /** In a second of such a day the sun moves by at most 0.01 degrees. */
    private static final double DAY_SECONDS = 36_000;

    private final AirTables air = AirTables.of(Air.CLEAR);

    @Override
    public Claim claim() {
        return new Claim(
                "sky-sweep",
                "While the sun rises in steps of 0.01 degrees (all of them from −10 to 22, one in each degree above),"
                    + " and while the clock moves it by as much at 200 instants of a year, no direction of sky and"
                    + " ground changes by more than 2 codes in a step, at any fixed exposure up to the one that auto"
                    + " calls for with the back to the sun (2 stops while the sun sets), and above 0.1 degrees at any"
                    + " exposure; none is negative or not a number.",
                "stretches",
                SWEEP_UNITS + HIGH_UNITS + HOUR_UNITS,
                40);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) {
        return ProofResult.ofUnits(from, count, progress, unit -> stretch(unit));
    }

    private ProofResult stretch(long unit) {
        if (unit < SWEEP_UNITS) {
            return swept(LOWEST_DEGREES + unit * STEPS * STEP_DEGREES, STEPS);
        }
        SplittableRandom random = new SplittableRandom(Hash64.combine(23, unit));
        return unit < SWEEP_UNITS + HIGH_UNITS
                ? swept(SWEPT_TO + unit - SWEEP_UNITS + random.nextDouble(0.99), 1)
                : timed(random);
    }

    private ProofResult swept(double from, int steps) {
        Codes codes = new Codes("sun");
        for (int step = 0; step <= steps; step++) {
            double degrees = from + step * STEP_DEGREES;
            double angle = Math.toRadians(degrees);
            Vec3 towards = new Vec3(0, Math.sin(angle), -Math.cos(angle));
            codes.follow(degrees, at(Atmosphere.CLEAR, towards, 0));
        }
        return codes.result();
    }

    private ProofResult timed(SplittableRandom random) {
        Atmosphere clear = Atmosphere.CLEAR;
        Atmosphere sky = new Atmosphere(
                clear.groundAlbedo(),
                clear.mieScale(),
                clear.mieG(),
                clear.ozoneScale(),
                random.nextDouble(-90, 90),
                random.nextDouble(1, 366),
                24 * random.nextDouble(),
                DAY_SECONDS,
                clear.sunRadiusDegrees());
        Codes codes = new Codes("hour");
        for (int step = 0; step <= 1; step++) {
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
                    .plus(CelestialPositions.nightGlow((Atmosphere) now.sky(), towards.y(), direction.y()))
                    .scaled(SOLAR_IRRADIANCE);
            light[3 * i] = radiance.x();
            light[3 * i + 1] = radiance.y();
            light[3 * i + 2] = radiance.z();
        }
        return light;
    }

    /** Directions are densest at the horizon, which none of them meets. */
    private static Vec3 direction(int index) {
        double fraction = 2 * (index / AZIMUTHS + 0.5) / RINGS - 1;
        double elevation = Math.signum(fraction) * fraction * fraction * Math.PI / 2;
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
        private int steps;

        Codes(String what) {
            this.what = what;
        }

        void follow(double place, Environment now) {
            double[] light = light(now);
            double exposure = longestExposure(now.sun().directionTowardsSun().y());
            for (int i = 0; i < light.length; i++) {
                if (!(light[i] >= 0 && light[i] < Double.POSITIVE_INFINITY)) {
                    fail(place, now, i, light[i] + " is no radiance");
                } else if (before != null) {
                    double jump = jump(before[i], light[i], exposure);
                    greatest = Math.max(greatest, jump);
                    if (jump > MOST_CODES) {
                        fail(place, now, i, "jumps by " + jump + " codes");
                    }
                }
            }
            steps += before == null ? 0 : 1;
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
                    Figure.sum("steps", steps, ""),
                    Figure.greatest("greatest change in a step", greatest, "codes"));
        }
    }

    private static double longestExposure(double sunSine) {
        double degrees = Math.toDegrees(Math.asin(sunSine));
        if (degrees > DEGREES[DEGREES.length - 1]) {
            return Double.POSITIVE_INFINITY;
        }
        int i = 0;
        while (i < DEGREES.length - 2 && degrees > DEGREES[i + 1]) {
            i++;
        }
        double fraction = Math.max(0, (degrees - DEGREES[i]) / (DEGREES[i + 1] - DEGREES[i]));
        return Math.pow(2, AUTO_STOPS[i] + fraction * (AUTO_STOPS[i + 1] - AUTO_STOPS[i]));
    }

    /** Returns the greatest change at any exposure: the longer one is, the greater, until the brighter value is white. */
    private static double jump(double from, double to, double longest) {
        double exposure = Math.min(longest, 1 / Math.max(1e-30, Math.max(from, to)));
        return Math.abs(code(to * exposure) - code(from * exposure));
    }

    private static double code(double linear) {
        return 255 * ToneMapping.displayValue(linear, 1, ToneCurve.CLIP);
    }
}
