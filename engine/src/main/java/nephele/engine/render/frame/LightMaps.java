package nephele.engine.render.frame;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.Level;
import nephele.engine.level.appearance.WeatherClouds;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.scene.dynamic.CharacterPresence;
import nephele.engine.scene.light.LightRequirements;

/**
 * The textures with which a level is lit. Passes are required, declare reads, compile and bind by this one value.
 *
 * @param all textures for solids, with the light map of static faces
 * @param dynamicObjects textures for dynamic objects, which have no place in the light map
 * @param gun textures for the gun before the eye, on which no dynamic object's shadow falls
 */
public record LightMaps(TargetReads all, TargetReads dynamicObjects, TargetReads gun) {
    public static LightMaps of(Level level, StaticShapes statics, Quality quality, CharacterPresence character) {
        List<Target> shadows = new ArrayList<>();
        boolean moving = !level.bodies().isEmpty() || character == CharacterPresence.POSSIBLE;
        boolean lights = quality.lightShadows() > 0 && LightRequirements.lightShadow(level);
        addIf(LightRequirements.sunShadow(level, statics), Target.SUN_SHADOW, shadows);
        addIf(lights, Target.LIGHT_SHADOW, shadows);
        addIf(
                moving
                        && LightRequirements.sun(level)
                        && level.environment().sun().castsShadow(),
                Target.DYNAMIC_SUN_SHADOW,
                shadows);
        addIf(moving && lights, Target.DYNAMIC_LIGHT_SHADOW, shadows);
        addIf(
                LightRequirements.sun(level)
                        && !WeatherClouds.all(level.environment()).isEmpty(),
                Target.CLOUD_SHADE,
                shadows);
        List<Target> all = new ArrayList<>(shadows);
        addIf(LightRequirements.skyVisibility(level), Target.SKY_VISIBILITY, all);
        List<Target> still = new ArrayList<>(shadows);
        still.removeAll(List.of(Target.DYNAMIC_SUN_SHADOW, Target.DYNAMIC_LIGHT_SHADOW));
        return new LightMaps(new TargetReads(all), new TargetReads(shadows), new TargetReads(still));
    }

    private static void addIf(boolean wanted, Target target, List<Target> targets) {
        if (wanted) {
            targets.add(target);
        }
    }

    public boolean has(Target target) {
        return all.targets().contains(target);
    }
}
