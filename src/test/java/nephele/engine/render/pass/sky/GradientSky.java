package nephele.engine.render.pass.sky;

import nephele.engine.level.Sky;
import nephele.engine.math.Vec3;

/** The Java twin of {@code gradient.frag}. */
public final class GradientSky {
    private GradientSky() {}

    /**
     * Returns the radiance.
     *
     * @param sineOfAltitude −1 straight down, 1 straight up
     */
    public static Vec3 radiance(Sky.Gradient sky, double sineOfAltitude) {
        Vec3 end = sineOfAltitude > 0 ? sky.zenith() : sky.ground();
        double t = Math.abs(sineOfAltitude);
        Vec3 h = sky.horizon();
        return h.lerp(end, t);
    }
}
