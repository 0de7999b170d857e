package nephele.engine.reference.sky;

import java.util.List;
import nephele.engine.atmosphere.AirTables;
import nephele.engine.level.Environment;
import nephele.engine.level.Sky;
import nephele.engine.level.Sun;
import nephele.engine.level.appearance.AirCache;
import nephele.engine.level.appearance.CelestialPositions;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.level.appearance.Moonlight;
import nephele.engine.math.Directions;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.reference.volume.DistantLight;
import nephele.engine.reference.volume.Surroundings;

/**
 * The light around clouds in the air of a round planet. Sun and moon that reach a place are dimmed by the air above it,
 * the sky is that of the place's own height, zenith, sun and moon; clouds shade no air, and the ground on the mean.
 */
final class OverPlanet implements Surroundings {
    private final Sky.Atmosphere atmosphere;
    private final Vec3 outside;
    private final LightOverPlanet sun;

    /** {@code null} while it does not shine. */
    private final LightOverPlanet moon;

    private final List<DistantLight> lights;
    private final double groundFraction;

    private OverPlanet(Sky.Atmosphere atmosphere, Sun sun, double groundFraction) {
        this.groundFraction = groundFraction;
        this.atmosphere = atmosphere;
        outside = sun.irradiance();
        AirTables tables = AirCache.tables(Daylight.air(atmosphere));
        this.sun = new LightOverPlanet(tables, outside, outside, Directions.unit(sun.directionTowardsSun()));
        Moonlight night = Moonlight.of(atmosphere, sun);
        moon = night.shines()
                ? new LightOverPlanet(
                        tables,
                        outside.times(night.ofWholeDisc()),
                        outside.times(night.irradiance()),
                        night.towardsMoon())
                : null;
        lights = moon == null ? List.of(this.sun) : List.of(this.sun, moon);
    }

    /**
     * @param environment with a sky of kind atmosphere and the sun of the time
     * @param groundFraction of its light that the ground keeps under the clouds
     */
    static OverPlanet of(Environment environment, double groundFraction) {
        return new OverPlanet((Sky.Atmosphere) environment.sky(), environment.sun(), groundFraction);
    }

    @Override
    public List<DistantLight> lights() {
        return lights;
    }

    @Override
    public Vec3 skylight(Vec3 from, Vec3 direction) {
        PlanetPlace place = PlanetPlace.of(from);
        Vec3 zenith = place.zenith();
        Vec3 glow = CelestialPositions.nightGlow(atmosphere, zenith.dot(sun.towards()), zenith.dot(direction));
        Vec3 sum = sun.skylight(place, direction).plus(glow.times(outside));
        Vec3 all = moon == null ? sum : sum.plus(moon.skylight(place, direction));
        boolean meetsGround = PlanetPlace.reachMetres(Ray.of(from, direction)) < Double.POSITIVE_INFINITY;
        return meetsGround ? all.scaled(groundFraction) : all;
    }

    @Override
    public double reachMetres(Ray ray) {
        return PlanetPlace.reachMetres(ray);
    }

    @Override
    public boolean isLightBlocked(Ray ray) {
        return false;
    }

    @Override
    public boolean isPathBlocked(Ray ray, double toMetres) {
        return false;
    }
}
