package nephele.engine.reference.volume;

import java.util.List;
import nephele.engine.level.appearance.SkyRadiance;
import nephele.engine.math.Directions;
import nephele.engine.math.Ray;
import nephele.engine.math.Vec3;

/** The light around media without air: a sun without a visible disc, and a sky, which are the same everywhere. */
public final class OutsideLight implements Surroundings {
    private final List<DistantLight> lights;
    private final SkyRadiance sky;

    private OutsideLight(List<DistantLight> lights, SkyRadiance sky) {
        this.lights = lights;
        this.sky = sky;
    }

    /** Returns the light of a sky alone. */
    public static OutsideLight of(SkyRadiance sky) {
        return new OutsideLight(List.of(), sky);
    }

    /**
     * Returns the light of a sun and a sky.
     *
     * @param towardsSun of any length but zero
     * @param irradiance of the sun, RGB, on a plane perpendicular to its beam
     */
    public static OutsideLight of(Vec3 towardsSun, Vec3 irradiance, SkyRadiance sky) {
        Vec3 towards = Directions.unit(towardsSun);
        if (towards == null) {
            throw new IllegalArgumentException("the direction towards the sun has no length");
        }
        return new OutsideLight(List.of(new DistantLight.Even(towards, irradiance)), sky);
    }

    @Override
    public List<DistantLight> lights() {
        return lights;
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
    public boolean isLightBlocked(Ray ray) {
        return false;
    }

    @Override
    public boolean isPathBlocked(Ray ray, double toMetres) {
        return false;
    }
}
