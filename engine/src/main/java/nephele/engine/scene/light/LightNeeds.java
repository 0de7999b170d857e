package nephele.engine.scene.light;

import nephele.engine.level.Level;
import nephele.engine.level.Light;
import nephele.engine.level.Sky;
import nephele.engine.level.Sun;
import nephele.engine.level.appearance.Lamp;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Vec3;

/** Which kinds of light a level asks for. Each answers no as soon as its cause is taken away. */
public final class LightNeeds {
    private LightNeeds() {}

    public static boolean sun(Level level) {
        Sun sun = level.environment().sun();
        return sun != null && !sun.irradiance().equals(Vec3.ZERO);
    }

    /**
     * A sun that casts, and a model or more than one solid: a shadow is possible, {@link ShadowCasters} know whether it is
     * there.
     */
    public static boolean sunCasts(Level level) {
        return sun(level)
                && level.environment().sun().castsShadow()
                && (level.solids().size() > 1 || !level.models().isEmpty());
    }

    /** A sun that casts, and a model or a solid that another one can be shaded by. */
    public static boolean sunShadow(Level level, StaticShapes statics) {
        return sunCasts(level)
                && (!level.models().isEmpty()
                        || ShadowCasters.any(
                                statics.solids(), level.environment().sun().directionTowardsSun()));
    }

    public static boolean lamps(Level level) {
        return hasSurfaces(level)
                && level.lights().stream().anyMatch(light -> Lamp.of(light).isPresent());
    }

    /** A lamp that casts, and a model or more than one solid or body: a convex one does not shade itself. */
    public static boolean lampShadow(Level level) {
        boolean several = level.solids().size() + level.bodies().size() > 1
                || !level.models().isEmpty();
        return several && lamps(level) && level.lights().stream().anyMatch(LightNeeds::casts);
    }

    /** Whether a lamp lights anything and casts. */
    public static boolean casts(Light light) {
        return light.castsShadow() && Lamp.of(light).isPresent();
    }

    /** A sky that shines, solids or models for it to fall on, and no constant in its place. */
    public static boolean skyVisibility(Level level) {
        return hasSurfaces(level) && skyShines(level);
    }

    /** What there is to be lit and to shade, as a reason is told. */
    public static String surfaces(Level level) {
        if (level.models().isEmpty()) {
            return "solids";
        }
        return level.solids().isEmpty() ? "models" : "solids, models";
    }

    /** Whether anything that never moves is there to be lit. */
    public static boolean hasSurfaces(Level level) {
        return !level.solids().isEmpty() || !level.models().isEmpty();
    }

    /** A sky that shines, and no constant in its place. */
    public static boolean skyShines(Level level) {
        return level.environment().ambient() == null
                && shines(level.environment().sky());
    }

    private static boolean shines(Sky sky) {
        boolean isBlack =
                sky instanceof Sky.Constant constant && constant.radiance().equals(Vec3.ZERO);
        return sky != null && !isBlack;
    }
}
