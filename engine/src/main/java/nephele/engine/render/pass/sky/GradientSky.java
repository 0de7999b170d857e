package nephele.engine.render.pass.sky;

import nephele.engine.level.Sky;
import nephele.engine.math.Vec3;

/** The Java twin of {@code gradient.frag}. */
public final class GradientSky {
    /** Stands in for computed scattering: a clear day, linear radiance. */
    static final Sky.Gradient ATMOSPHERE_STAND_IN =
            new Sky.Gradient(new Vec3(0.12, 0.28, 0.65), new Vec3(0.62, 0.74, 0.88), new Vec3(0.16, 0.15, 0.14));

    private GradientSky() {}

    /** @param sineOfAltitude −1 straight down, 1 straight up */
    public static Vec3 radiance(Sky.Gradient sky, double sineOfAltitude) {
        Vec3 end = sineOfAltitude > 0 ? sky.zenith() : sky.ground();
        double t = Math.abs(sineOfAltitude);
        Vec3 h = sky.horizon();
        return new Vec3(h.x() + (end.x() - h.x()) * t, h.y() + (end.y() - h.y()) * t, h.z() + (end.z() - h.z()) * t);
    }
}
