package nephele.engine.level.appearance;

import java.util.Optional;
import nephele.engine.atmosphere.SkyTable;
import nephele.engine.level.Sky;
import nephele.engine.level.Sun;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;

/**
 * Moon and stars over an atmosphere as an eye sees them, which traced pictures are without; the twin of {@code
 * nightLight} in {@code atmosphere.frag}. They fade in while the sun sets.
 */
public final class NightSky {
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

    private NightSky(Sky.Atmosphere sky, Sun sun, double share, double eyeHeight) {
        towardsSun = Directions.unit(sun.directionTowardsSun());
        towardsMoon = Heavens.towardsMoon(sky);
        starAxes = Heavens.celestialAxes(sky);
        strength = sun.irradiance().scaled(share);
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
        return through(direction, MOON_ALBEDO.scaled(lit * phase / Math.PI * MoonFace.albedo(place)));
    }

    /**
     * Returns the radiance of stars in a unit direction, zero behind the moon and below the horizon.
     *
     * @param pixelRadians of the picture; a star fills about one
     */
    public Vec3 stars(Vec3 direction, double pixelRadians) {
        boolean isHidden = direction.minus(towardsMoon).length() < MOON_RADIUS_RADIANS;
        return isHidden ? Vec3.ZERO : through(direction, StarCells.radiance(celestial(direction), pixelRadians));
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
}
