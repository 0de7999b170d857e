package nephele.engine.level.appearance;

import java.util.Optional;
import nephele.engine.atmosphere.SkyTable;
import nephele.engine.level.Sky;
import nephele.engine.level.Sun;
import nephele.engine.math.Directions;
import nephele.engine.math.Pcg3d;
import nephele.engine.math.SeededNoise;
import nephele.engine.math.Vec3;

/**
 * Moon and stars over an atmosphere as an eye sees them; traced pictures of direct light are without. The twin of {@code nightLight} in {@code atmosphere.frag}. They fade in while the sun sets.
 */
public final class NightSky {
    /** Cells along a side of the cube of stars, with one star in each: some 9600 to magnitude 6. */
    private static final int STAR_CELLS = 40;

    /** The sun's magnitude; magnitudes are −2.5 log10 of flux. */
    private static final double SUN_MAGNITUDE = -26.74;

    /** Directions to the middles of the plains, east, north and towards the planet, and their radii in radians. */
    private static final double[][] SEAS = {
        {-0.231, 0.545, 0.806, 0.314},
        {0.273, 0.469, 0.840, 0.192},
        {0.509, 0.156, 0.847, 0.227},
        {0.820, 0.292, 0.493, 0.140},
        {0.770, -0.139, 0.623, 0.192},
        {0.554, -0.259, 0.791, 0.105},
        {-0.273, -0.358, 0.893, 0.192},
        {-0.575, -0.407, 0.710, 0.122},
        {-0.797, 0.342, 0.498, 0.314},
        {-0.718, -0.052, 0.694, 0.244},
        {-0.610, 0.139, 0.780, 0.209},
        {0.047, 0.839, 0.543, 0.105},
        {-0.256, 0.839, 0.481, 0.105},
        {0.068, 0.225, 0.972, 0.087},
        {-0.385, -0.174, 0.907, 0.122}
    };

    /** Directions to young craters with bright rays, and their sizes. */
    private static final double[][] RAYED = {
        {-0.140, -0.682, 0.718, 0.628},
        {-0.337, 0.174, 0.925, 0.279},
        {-0.610, 0.139, 0.780, 0.157},
        {-0.668, 0.407, 0.623, 0.157},
        {0.864, -0.156, 0.479, 0.209},
        {0.703, 0.276, 0.656, 0.122}
    };

    private static final SeededNoise NOISE = new SeededNoise(0);

    /** Moves the cells of the noise, as the shader does. */
    private static final double NOISE_CELLS = 4096;

    public static final double MOON_RADIUS_RADIANS = 0.0045;

    private static final Vec3 MOON_ALBEDO = new Vec3(1, 0.97, 0.92).scaled(0.12);
    private static final double FULL_SINE = -0.10;

    private final Vec3 towardsSun;
    private final Vec3 towardsMoon;
    private final Vec3[] starAxes;
    /** The share of its light that the time of day lets be seen, times the sun's irradiance. */
    private final Vec3 strength;

    private final Vec3 zenithDepth;
    private final double horizonRadians;

    private NightSky(Sky.Atmosphere sky, Sun sun, double fraction, double eyeHeight) {
        towardsSun = Directions.unit(sun.directionTowardsSun());
        towardsMoon = CelestialPositions.towardsMoon(sky);
        starAxes = CelestialPositions.celestialAxes(sky);
        strength = sun.irradiance().scaled(fraction);
        Vec3 zenith = Daylight.air(sky).transmittance(0, 1);
        zenithDepth = new Vec3(-Math.log(zenith.x()), -Math.log(zenith.y()), -Math.log(zenith.z()));
        horizonRadians = SkyTable.horizonRadians(Math.max(0, eyeHeight));
    }

    /**
     * Returns the night of an hour; empty by day.
     *
     * @param sun of the hour
     */
    public static Optional<NightSky> of(Sky.Atmosphere sky, Sun sun, double eyeHeight) {
        double sine = Directions.unit(sun.directionTowardsSun()).y();
        double t = Math.max(0, (sine - FULL_SINE) / -FULL_SINE);
        return t < 1 ? Optional.of(new NightSky(sky, sun, 1 - t * t * (3 - 2 * t), eyeHeight)) : Optional.empty();
    }

    /** Returns the unit direction of the moon. */
    public Vec3 towardsMoon() {
        return towardsMoon;
    }

    /**
     * Returns the radiance of the moon in a unit direction, zero beside its disc and below the horizon: a sphere that the
     * sun lights and that shows the planet one side.
     */
    public Vec3 moon(Vec3 direction) {
        double along = towardsMoon.dot(direction);
        Vec3 side = direction.addScaled(-along, towardsMoon).scaled(1 / MOON_RADIUS_RADIANS);
        double square = side.dot(side);
        if (square >= 1 || along < 0) {
            return Vec3.ZERO;
        }
        double outwards = Math.sqrt(1 - square) + 1e-4;
        Vec3 normal = Directions.unit(side.addScaled(-outwards, towardsMoon));
        Vec3 west = Directions.unit(starAxes[2].cross(towardsMoon));
        Vec3 north = towardsMoon.cross(west);
        Vec3 place = new Vec3(-normal.dot(west), normal.dot(north), -normal.dot(towardsMoon));
        // Lommel and Seeliger's law of a rough surface: the full moon is as bright at its edge as in its middle.
        double sunwards = Math.max(0, normal.dot(towardsSun));
        double lit = 2 * sunwards / (sunwards + Math.max(outwards, 0.05));
        double phase = 0.75 - 0.25 * towardsMoon.dot(towardsSun);
        return through(direction, MOON_ALBEDO.scaled(lit * phase / Math.PI * moonAlbedo(place)));
    }

    /**
     * Returns the radiance of stars in a unit direction, zero behind the moon and below the horizon.
     *
     * @param pixelRadians of the picture; a star fills about one
     */
    public Vec3 stars(Vec3 direction, double pixelRadians) {
        boolean isHidden = direction.minus(towardsMoon).length() < MOON_RADIUS_RADIANS;
        return isHidden ? Vec3.ZERO : through(direction, starRadiance(celestial(direction), pixelRadians));
    }

    private Vec3 celestial(Vec3 direction) {
        return new Vec3(direction.dot(starAxes[0]), direction.dot(starAxes[1]), direction.dot(starAxes[2]));
    }

    /** Returns what the eye sees of radiance beyond the air, per unit irradiance of the sun. */
    private Vec3 through(Vec3 direction, Vec3 radiance) {
        if (Math.asin(direction.y()) <= horizonRadians) {
            return Vec3.ZERO;
        }
        double length = 1 / (Math.max(direction.y(), 0) + 0.03);
        return new Vec3(
                radiance.x() * strength.x() * Math.exp(-zenithDepth.x() * length),
                radiance.y() * strength.y() * Math.exp(-zenithDepth.y() * length),
                radiance.z() * strength.z() * Math.exp(-zenithDepth.z() * length));
    }

    /**
     * Returns the albedo of a place on the moon, a unit vector east, north and towards the planet, relative to the mean:
     * dark plains and rayed craters. The twin of {@code moonAlbedo} in {@code atmosphere.frag}.
     */
    private static double moonAlbedo(Vec3 place) {
        double rough = 0;
        double weight = 0.5;
        double scale = 2.7;
        for (int octave = 0; octave < 5; octave++) {
            rough += weight
                    * (NOISE.at(
                                    NOISE_CELLS + scale * place.x(),
                                    NOISE_CELLS + scale * place.y(),
                                    NOISE_CELLS + scale * place.z())
                            - 0.5);
            weight *= 0.65;
            scale *= 2;
        }
        double sea = 0;
        for (double[] plain : SEAS) {
            double apart = place.minus(direction(plain)).length() / plain[3];
            sea = Math.max(sea, 1 - smoothStep((apart + 1.7 * rough - 0.85) / 0.4));
        }
        double ground = (1 + 0.6 * rough) * (1 - sea) + (0.5 + 0.3 * rough) * sea;
        return ground + 0.45 * rays(place);
    }

    private static double rays(Vec3 place) {
        double bright = 0;
        for (int i = 0; i < RAYED.length; i++) {
            Vec3 crater = direction(RAYED[i]);
            Vec3 from = place.minus(crater);
            double apart = from.length() / RAYED[i][3];
            Vec3 east = new Vec3(0, 1, 0).cross(crater);
            east = east.scaled(1 / east.length());
            double angle = Math.atan2(from.dot(crater.cross(east)), from.dot(east));
            double streak = 0.5 + 0.5 * Math.sin(angle * 9 + 2 * Math.sin(angle * 4 + i));
            bright = Math.max(bright, Math.exp(-1.6 * apart) * (0.15 + 0.85 * streak * streak * streak));
            bright = Math.max(bright, Math.exp(-apart * apart * 90));
        }
        return bright;
    }

    private static Vec3 direction(double[] row) {
        return new Vec3(row[0], row[1], row[2]);
    }

    private static double smoothStep(double t) {
        double clamped = Math.max(0, Math.min(1, t));
        return clamped * clamped * (3 - 2 * clamped);
    }

    /**
     * Returns the radiance of stars per unit irradiance of the sun, the twin of {@code stars} in {@code atmosphere.frag}.
     *
     * @param direction unit, along the axes of the stars
     */
    private static Vec3 starRadiance(Vec3 direction, double pixelRadians) {
        double[] d = {direction.x(), direction.y(), direction.z()};
        double x = Math.abs(d[0]);
        double y = Math.abs(d[1]);
        double z = Math.abs(d[2]);
        int axis = x > y && x > z ? 0 : y > z ? 1 : 2;
        int next = (axis + 1) % 3;
        int last = (axis + 2) % 3;
        double along = Math.abs(d[axis]);
        int column = (int) Math.floor((d[next] / along * 0.5 + 0.5) * STAR_CELLS);
        int row = (int) Math.floor((d[last] / along * 0.5 + 0.5) * STAR_CELLS);
        Pcg3d random = Pcg3d.of(column + 64, row, axis * 2 + (d[axis] > 0 ? 1 : 0));
        double[] star = new double[3];
        star[axis] = Math.signum(d[axis]);
        star[next] = (column + 0.15 + 0.7 * Pcg3d.unit(random.x())) / STAR_CELLS * 2 - 1;
        star[last] = (row + 0.15 + 0.7 * Pcg3d.unit(random.y())) / STAR_CELLS * 2 - 1;
        double spread = 0.6 * Math.max(pixelRadians, 2e-4);
        double apart =
                direction.minus(Directions.unit(star[0], star[1], star[2])).length();
        // The number of stars grows by 10^0.5 with each magnitude.
        double magnitude = Math.max(-1, 6 + 2 * Math.log10(Math.max(Pcg3d.unit(random.z()), 1e-4)));
        double flux = Math.pow(10, -0.4 * (magnitude - SUN_MAGNITUDE)) * Moonlight.NIGHT_GAIN;
        double square = 2 * spread * spread;
        return tint(Pcg3d.unit(random.x())).scaled(flux * Math.exp(-apart * apart / square) / (Math.PI * square));
    }

    /** Returns a colour between an orange and a blue star's. */
    private static Vec3 tint(double random) {
        double blue = random * 57 - Math.floor(random * 57);
        return new Vec3(1, 0.8, 0.6).scaled(1 - blue).addScaled(blue, new Vec3(0.7, 0.85, 1));
    }
}
