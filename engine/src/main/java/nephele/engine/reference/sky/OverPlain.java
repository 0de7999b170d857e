package nephele.engine.reference.sky;

import java.util.Optional;
import nephele.engine.level.Environment;
import nephele.engine.level.Sun;
import nephele.engine.level.appearance.SkyRadiance;
import nephele.engine.math.Directions;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;
import nephele.engine.reference.volume.Surroundings;
import org.joml.Vector3d;

/** The light around clouds without air: sun and sky are the same everywhere. */
record OverPlain(Vec3 towardsSun, Vec3 irradiance, SkyRadiance sky) implements Surroundings {
    static OverPlain of(Environment environment, Optional<SkyRadiance> sky) {
        Sun sun = environment.sun();
        return new OverPlain(
                sun == null ? new Vec3(0, 1, 0) : Directions.unit(sun.directionTowardsSun()),
                sun == null ? Vec3.ZERO : sun.irradiance(),
                sky.orElse((height, x, y, z) -> new Vector3d()));
    }

    @Override
    public Vec3 sunlight(Vec3 place) {
        return irradiance;
    }

    @Override
    public Vec3 skylight(Vec3 from, Vec3 direction) {
        return Vec3.of(sky.from(from.y(), direction.x(), direction.y(), direction.z()));
    }

    @Override
    public double reachMetres(Ray ray) {
        return Double.POSITIVE_INFINITY;
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
