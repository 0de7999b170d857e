package nephele.engine.render.frame;

import java.util.ArrayList;
import java.util.Collection;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import nephele.engine.level.Level;
import nephele.engine.level.appearance.WeatherClouds;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.render.frame.Quality.DirectLight;
import nephele.engine.render.frame.Quality.LightDirections;
import nephele.engine.render.frame.Quality.NormalMaps;
import nephele.engine.scene.dynamic.CharacterPresence;
import nephele.engine.scene.light.LightRequirements;
import nephele.engine.scene.light.bake.IndirectLight;

/**
 * The textures with which a level is lit, and the light that static surfaces take from them. Passes are required, declare
 * reads, compile and bind by this one value.
 *
 * @param solids textures for solids and models, with the light map of static faces
 * @param ground textures for terrains, which have light maps of their own
 * @param dynamicObjects textures for dynamic objects, which have no place in the light map
 * @param gun textures for the gun before the eye, on which no dynamic object's shadow falls
 * @param baked the light that static surfaces take from a bake; empty without one
 */
public record LightMaps(
        TargetReads solids, TargetReads ground, TargetReads dynamicObjects, TargetReads gun, Set<Baked> baked) {
    /** A part of baked light. */
    public enum Baked {
        /** Light that other surfaces have reflected or emit; it is in every bake. */
        BOUNCED,
        /** Light of the sky, which is drawn live otherwise. */
        SKY,
        /** Light straight from {@link #SUN} or {@link #LAMPS}, or both. */
        DIRECT,
        SUN,
        LAMPS,
        /** Mean directions of the light, for normals that a normal map tilts. */
        DIRECTIONS,
        /** All but {@link #DIRECT} once more, for glossy surfaces, which would mirror a sun as wide as the sky. */
        MIRRORED
    }

    /** @param light {@code null} for none */
    public static LightMaps of(
            Level level, StaticShapes statics, IndirectLight light, Quality quality, CharacterPresence character) {
        Set<Baked> baked = baked(level, light, quality);
        boolean moving = !level.bodies().isEmpty() || character == CharacterPresence.POSSIBLE;
        boolean lamps = quality.lightShadows() > 0 && LightRequirements.lightShadow(level);
        boolean sun = LightRequirements.sunShadow(level, statics);
        boolean sunCasts =
                LightRequirements.sun(level) && level.environment().sun().castsShadow();
        // The maps of the static geometry are drawn once, so that what moves may have its shade.
        boolean othersAreLit = moving
                || !level.billboards().isEmpty()
                || level.models().stream().anyMatch(model -> model.impostor());
        List<Target> all = new ArrayList<>();
        addIf(sun && (othersAreLit || !baked.contains(Baked.SUN)), Target.SUN_SHADOW, all);
        addIf(lamps && (othersAreLit || !baked.contains(Baked.LAMPS)), Target.LIGHT_SHADOW, all);
        addIf(moving && sunCasts && !baked.contains(Baked.SUN), Target.DYNAMIC_SUN_SHADOW, all);
        addIf(moving && lamps && !baked.contains(Baked.LAMPS), Target.DYNAMIC_LIGHT_SHADOW, all);
        boolean hasClouds = !WeatherClouds.all(level.environment()).isEmpty();
        addIf(LightRequirements.sun(level) && hasClouds, Target.CLOUD_SHADE, all);
        List<Target> still = new ArrayList<>(all);
        still.removeAll(List.of(Target.DYNAMIC_SUN_SHADOW, Target.DYNAMIC_LIGHT_SHADOW));
        List<Target> ground = new ArrayList<>(all);
        ground.removeIf(
                target -> (target == Target.SUN_SHADOW || target == Target.CLOUD_SHADE) && baked.contains(Baked.SUN)
                        || target == Target.LIGHT_SHADOW && baked.contains(Baked.LAMPS));
        List<Target> solids = new ArrayList<>(ground);
        addIf(LightRequirements.skyVisibility(level) && readsSky(level, baked), Target.SKY_VISIBILITY, solids);
        addIf(baked.contains(Baked.BOUNCED) && LightRequirements.hasMeshes(level), Target.BAKED_LIGHT, solids);
        return new LightMaps(
                new TargetReads(solids),
                new TargetReads(ground),
                new TargetReads(all),
                new TargetReads(still),
                Set.copyOf(baked));
    }

    private static Set<Baked> baked(Level level, IndirectLight light, Quality quality) {
        Set<Baked> baked = EnumSet.noneOf(Baked.class);
        if (light == null || !LightRequirements.hasSurfaces(level)) {
            return baked;
        }
        boolean isDirectBaked = quality.directLight() == DirectLight.BAKED
                && light.layers().stream().anyMatch(layer -> layer.course() == IndirectLight.Course.DIRECT);
        boolean isBounced = light.layers().stream().anyMatch(layer -> layer.course() == IndirectLight.Course.INDIRECT);
        if (!isDirectBaked && !isBounced) {
            return baked;
        }
        baked.add(Baked.BOUNCED);
        boolean isTilted = level.materials().stream()
                .anyMatch(material -> !material.lambert()
                        || material.normalTexture() != null && quality.normalMaps() == NormalMaps.ON);
        addIf(light.sky() == IndirectLight.SkyLight.BAKED, Baked.SKY, baked);
        addIf(isDirectBaked, Baked.DIRECT, baked);
        addIf(isDirectBaked && LightRequirements.sunStands(level), Baked.SUN, baked);
        addIf(isDirectBaked && LightRequirements.lights(level), Baked.LAMPS, baked);
        boolean isGlossy = level.materials().stream().anyMatch(material -> !material.lambert());
        addIf(isDirectBaked && isBounced && isGlossy, Baked.MIRRORED, baked);
        addIf(isTilted && quality.lightDirections() == LightDirections.ON, Baked.DIRECTIONS, baked);
        return baked;
    }

    /** Lightning reaches only where the sky is visible, wherever the sky's own light is from. */
    private static boolean readsSky(Level level, Set<Baked> baked) {
        return !baked.contains(Baked.SKY) || level.environment().hasLightning();
    }

    private static <T> void addIf(boolean wanted, T element, Collection<T> elements) {
        if (wanted) {
            elements.add(element);
        }
    }

    /** Returns true if any surface reads a target. */
    public boolean has(Target target) {
        return Stream.of(solids, ground, dynamicObjects, gun).anyMatch(reads -> reads.has(target));
    }

    /** Returns the number of layers of a texture of baked light: radiance, directions, what is mirrored. */
    public int layers() {
        return 1 + (bakes(Baked.DIRECTIONS) ? 1 : 0) + (bakes(Baked.MIRRORED) ? 1 : 0);
    }

    /** Returns true if static surfaces take a part of light from the bake. */
    public boolean bakes(Baked part) {
        return baked.contains(part);
    }
}
