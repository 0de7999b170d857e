package nephele.engine.reference.sky;

import nephele.engine.atmosphere.AirTables;
import nephele.engine.atmosphere.SkyLattice;
import nephele.engine.level.Environment;
import nephele.engine.level.Sky;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.level.appearance.Heavens;
import nephele.engine.level.appearance.SkyRadiance;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;

/** The sky that the ends of random walks see: an atmosphere by its lattice, every other kind as eyes see it. */
final class SkyOfPaths {
    private SkyOfPaths() {}

    /**
     * Returns the radiance for any number of threads.
     *
     * @param environment with the sun of its hour
     * @param seen what eyes see
     */
    static SkyRadiance of(Environment environment, SkyRadiance seen) {
        if (!(environment.sky() instanceof Sky.Atmosphere atmosphere) || environment.sun() == null) {
            return seen;
        }
        Vec3 towardsSun = Directions.unit(environment.sun().directionTowardsSun());
        Vec3 irradiance = environment.sun().irradiance();
        SkyLattice lattice = new SkyLattice(AirTables.of(Daylight.air(atmosphere)), towardsSun);
        return (height, x, y, z) -> lattice.radiance(height, new Vec3(x, y, z))
                .plus(Heavens.nightGlow(towardsSun.y(), y))
                .toVector()
                .mul(irradiance.toVector());
    }
}
