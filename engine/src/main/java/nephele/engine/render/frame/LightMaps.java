package nephele.engine.render.frame;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.Level;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.scene.light.LightNeeds;
import nephele.engine.scene.thing.FigurePresence;

/**
 * The textures that a level's light is looked up in. Passes are required, declare, compile and bind by this one value.
 *
 * @param all of solids: the light map of the static faces too
 * @param things of what moves, which has no place in the light map
 */
public record LightMaps(TargetReads all, TargetReads things) {
    public static LightMaps of(Level level, StaticShapes statics, FigurePresence figure) {
        List<Target> shadows = new ArrayList<>();
        boolean moving = !level.bodies().isEmpty() || figure == FigurePresence.POSSIBLE;
        boolean lamps = LightNeeds.lampShadow(level);
        addIf(LightNeeds.sunShadow(level, statics), Target.SUN_SHADOW, shadows);
        addIf(lamps, Target.LAMP_SHADOW, shadows);
        addIf(
                moving && LightNeeds.sun(level) && level.environment().sun().castsShadow(),
                Target.THING_SUN_SHADOW,
                shadows);
        addIf(moving && lamps, Target.THING_LAMP_SHADOW, shadows);
        List<Target> all = new ArrayList<>(shadows);
        addIf(LightNeeds.skyVisibility(level), Target.SKY_VISIBILITY, all);
        return new LightMaps(new TargetReads(all), new TargetReads(shadows));
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
