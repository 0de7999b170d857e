package nephele.engine.reference.sky;

import nephele.engine.atmosphere.Air;
import nephele.engine.atmosphere.AirTables;
import nephele.engine.atmosphere.SkyLattice;
import nephele.engine.level.Environment;
import nephele.engine.level.Sky;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.level.appearance.Heavens;
import nephele.engine.math.Directions;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.reference.volume.Surroundings;

/**
 * The light around clouds in the air of a round planet. The sun that reaches a place is dimmed by the air above it, the
 * sky is that of the place's own height, zenith and sun; clouds shade no air.
 *
 * @param irradiance of the sun outside the air
 * @param groundShare share of its light that the ground keeps under the clouds, on the mean
 */
record OverPlanet(
        Sky.Atmosphere atmosphere,
        Vec3 towardsSun,
        Vec3 irradiance,
        SunOverPlanet sun,
        SkyLattice sky,
        double groundShare)
        implements Surroundings {
    /**
     * @param environment with a sky of kind atmosphere and the sun of the time
     * @param groundShare share of its light that the ground keeps under the clouds
     */
    static OverPlanet of(Environment environment, double groundShare) {
        var atmosphere = (Sky.Atmosphere) environment.sky();
        Air air = Daylight.air(atmosphere);
        Vec3 towardsSun = Directions.unit(environment.sun().directionTowardsSun());
        Vec3 irradiance = environment.sun().irradiance();
        return new OverPlanet(
                atmosphere,
                towardsSun,
                irradiance,
                new SunOverPlanet(air, irradiance, towardsSun),
                new SkyLattice(AirTables.of(air), towardsSun.y()),
                groundShare);
    }

    @Override
    public Vec3 sunlight(Vec3 place) {
        return sun.at(PlanetPlace.of(place));
    }

    @Override
    public Vec3 skylight(Vec3 from, Vec3 direction) {
        PlanetPlace place = PlanetPlace.of(from);
        double sine = place.zenith().dot(direction);
        double sunSine = place.zenith().dot(towardsSun);
        Vec3 radiance = sky.radiance(place.altitudeMetres(), sine, sunSine, direction.dot(towardsSun))
                .plus(Heavens.nightGlow(atmosphere, sunSine, sine));
        var ray = Ray.of(from, direction);
        double share = PlanetPlace.reachMetres(ray) < Double.POSITIVE_INFINITY ? groundShare : 1;
        return new Vec3(radiance.x() * irradiance.x(), radiance.y() * irradiance.y(), radiance.z() * irradiance.z())
                .scaled(share);
    }

    @Override
    public double reachMetres(Ray ray) {
        return PlanetPlace.reachMetres(ray);
    }

    @Override
    public boolean isSunBlocked(Ray ray) {
        return false;
    }

    @Override
    public boolean isPathBlocked(Ray ray, double toMetres) {
        return false;
    }
}
