package nephele.editor.draw;

import java.util.List;
import nephele.engine.level.Environment;
import nephele.engine.level.Exposure;
import nephele.engine.level.Sky;
import nephele.engine.level.Sun;
import nephele.engine.level.ToneCurve;
import nephele.engine.math.Vec3;

/**
 * The light of the modes that show surfaces without the level's own light: constant from everywhere, and a weak sun
 * without shadows, so that the faces of a corner differ. A white surface reaches at most 1.
 */
public final class EvenLight {
    private static final Vec3 AMBIENT = new Vec3(0.42, 0.42, 0.42);
    private static final Vec3 IRRADIANCE = new Vec3(1.8, 1.8, 1.8);

    private EvenLight() {}

    /**
     * Returns the environment for a view, to draw a {@link SurfacesLevel} with: the sun is beside the eye, because
     * faces that a fixed sun does not reach would all look the same.
     */
    public static Environment seenFrom(Environment base, Vec3 right, Vec3 up, Vec3 back) {
        Vec3 towards = back.scaled(0.75).addScaled(0.45, up).addScaled(0.3, right);
        return environment(towards, base.sky());
    }

    /** Returns the environment while no view is known: the sun is above. */
    static Environment before(Vec3 background) {
        return environment(new Vec3(0, 1, 0), new Sky.Constant(background));
    }

    private static Environment environment(Vec3 towardsSun, Sky sky) {
        return new Environment(
                new Sun(towardsSun, IRRADIANCE, false),
                sky,
                AMBIENT,
                Exposure.NEUTRAL,
                ToneCurve.CLIP,
                null,
                List.of());
    }
}
