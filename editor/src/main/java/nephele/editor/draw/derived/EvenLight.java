package nephele.editor.draw.derived;

import java.util.List;
import nephele.engine.level.Body;
import nephele.engine.level.Environment;
import nephele.engine.level.Level;
import nephele.engine.level.Material;
import nephele.engine.level.ModelPlacement;
import nephele.engine.level.Sky;
import nephele.engine.level.Solid;
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
     * Returns the environment for a view, to draw a level of {@link #level} with: the sun is beside the eye, because
     * faces that a fixed sun does not reach would all look the same.
     */
    public static Environment seenFrom(Environment base, Vec3 right, Vec3 up, Vec3 back) {
        Vec3 towards = back.scaled(0.75).addScaled(0.45, up).addScaled(0.3, right);
        return environment(towards, base.sky());
    }

    private static Environment environment(Vec3 towardsSun, Sky sky) {
        return new Environment(
                new Sun(towardsSun, IRRADIANCE, false), sky, AMBIENT, 0, ToneCurve.CLIP, null, List.of());
    }

    /** The parts of a level that have surfaces. */
    record Surfaces(List<Material> materials, List<Solid> solids, List<ModelPlacement> models, List<Body> bodies) {
        boolean isSame(Surfaces other) {
            return other != null
                    && materials == other.materials
                    && solids == other.solids
                    && models == other.models
                    && bodies == other.bodies;
        }
    }

    /** Returns a level of surfaces alone: without lights, portals, mirrors, exits and player. */
    static Level level(Surfaces shown, Vec3 background) {
        return Level.of("", "", environment(new Vec3(0, 1, 0), new Sky.Constant(background)), List.of())
                .with(shown.materials, shown.solids, shown.bodies, shown.models);
    }
}
