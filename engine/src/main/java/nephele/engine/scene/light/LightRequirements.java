package nephele.engine.scene.light;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.Level;
import nephele.engine.level.Light;
import nephele.engine.level.Sky;
import nephele.engine.level.Sun;
import nephele.engine.level.appearance.Daylight;
import nephele.engine.level.appearance.PunctualLight;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Vec3;
import nephele.engine.scene.light.bake.BakedLight;

/** The kinds of light that a level needs. */
public final class LightRequirements {
    private LightRequirements() {}

    public static boolean sun(Level level) {
        Sun sun = level.environment().sun();
        return sun != null && !sun.irradiance().equals(Vec3.ZERO);
    }

    /** Returns true if there is a sun that does not move, whose light is baked with the clouds as they are at first. */
    public static boolean sunStands(Level level) {
        return sun(level) && !Daylight.moves(level.environment());
    }

    /**
     * Returns true if the sun casts shadows and there are a model, a terrain or several solids: a shadow is possible, and
     * {@link ShadowCasters} decides if there is one.
     */
    public static boolean sunCasts(Level level) {
        return sun(level)
                && level.environment().sun().castsShadow()
                && (level.solids().size() > 1 || shadesItself(level) || billboardsCast(level));
    }

    /** Returns true if there are billboards with edges, and surfaces that they can shade. */
    public static boolean billboardsCast(Level level) {
        return hasSurfaces(level) && level.billboards().stream().anyMatch(group -> !group.blended());
    }

    /** Returns true if there are shapes of which one part can shade another. */
    private static boolean shadesItself(Level level) {
        return !level.models().isEmpty() || !level.terrains().isEmpty();
    }

    /** Returns true if the sun casts shadows and there is a model, a terrain or a solid that another one can shade. */
    public static boolean sunShadow(Level level, StaticShapes statics) {
        return sunCasts(level)
                && (shadesItself(level)
                        || billboardsCast(level)
                        || Daylight.moves(level.environment())
                        || ShadowCasters.any(
                                statics.solids(),
                                Daylight.onGround(level.environment()).directionTowardsSun()));
    }

    /** Returns true if a light emits anything, and there are surfaces or billboards to light. */
    public static boolean lights(Level level) {
        return (hasSurfaces(level) || !level.billboards().isEmpty())
                && level.lights().stream()
                        .anyMatch(light -> PunctualLight.of(light).isPresent());
    }

    /**
     * Returns true if a punctual light casts shadows and there are a model, a terrain or several solids or bodies; a single convex
     * shape does not shade itself.
     */
    public static boolean lightShadow(Level level) {
        boolean several = level.solids().size() + level.bodies().size() > 1 || shadesItself(level);
        return several && lights(level) && level.lights().stream().anyMatch(LightRequirements::casts);
    }

    /** Returns true if a light emits anything and casts shadows. */
    public static boolean casts(Light light) {
        return light.castsShadow() && PunctualLight.of(light).isPresent();
    }

    /** Returns true if the sky emits light, there are solids or models to receive it, and no constant replaces it. */
    public static boolean skyVisibility(Level level) {
        return hasMeshes(level) && skyShines(level);
    }

    /** Returns true if the light that static geometry reflects was baked. */
    public static boolean bounces(BakedLight light) {
        return light != null && light.indirect() != null;
    }

    /** Returns the names of the kinds of surfaces, for the explanation of a need. */
    public static String surfaces(Level level) {
        List<String> kinds = new ArrayList<>();
        if (!level.solids().isEmpty()) {
            kinds.add("solids");
        }
        if (!level.models().isEmpty()) {
            kinds.add("models");
        }
        if (!level.terrains().isEmpty()) {
            kinds.add("terrains");
        }
        return kinds.isEmpty() ? "solids" : String.join(", ", kinds);
    }

    /** Returns true if there is static geometry to light. */
    public static boolean hasSurfaces(Level level) {
        return hasMeshes(level)
                || !level.models().isEmpty()
                || !level.terrains().isEmpty();
    }

    /** Returns true if there are solids, or models that are not drawn as impostors. */
    public static boolean hasMeshes(Level level) {
        return !level.solids().isEmpty() || level.models().stream().anyMatch(model -> !model.impostor());
    }

    /** Returns true if the sky emits light and no constant replaces it. */
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
