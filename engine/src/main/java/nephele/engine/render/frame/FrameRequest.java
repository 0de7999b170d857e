package nephele.engine.render.frame;

import nephele.engine.level.Level;
import nephele.engine.level.Sky;
import nephele.engine.level.appearance.SunAndMoon;
import nephele.engine.level.appearance.WeatherClouds;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.scene.dynamic.CharacterPresence;
import nephele.engine.scene.light.LightRequirements;
import nephele.engine.scene.light.bake.IndirectLight;

/**
 * The request that a renderer's frames fulfil: everything on which the choice of passes depends.
 *
 * @param lightMaps textures with which the level is lit
 * @param character whether the player's character, and what it holds, can appear
 */
public record FrameRequest(
        Level level, LightMaps lightMaps, Output output, Quality quality, CharacterPresence character) {
    /**
     * Returns a request.
     *
     * @param statics the shapes that follow from the level
     * @param light that was baked for them; {@code null} for none
     */
    public static FrameRequest of(
            Level level,
            StaticShapes statics,
            IndirectLight light,
            Output output,
            Quality quality,
            CharacterPresence character) {
        CharacterPresence presence = character.in(level);
        return new FrameRequest(
                level, LightMaps.of(level, statics, light, quality, presence), output, quality, presence);
    }

    /** Returns a request of single frames with quality HIGH, without a character. @param light {@code null} for none */
    public static FrameRequest of(PlacedLevel placed, IndirectLight light, Output output) {
        return of(placed.level(), placed.statics(), light, output, Quality.HIGH.inOneFrame(), CharacterPresence.NEVER);
    }

    /** Returns a request of single frames with quality HIGH, without a character and baked light. */
    public static FrameRequest of(PlacedLevel placed, Output output) {
        return of(placed, null, output);
    }

    public boolean hasBodies() {
        return !level.bodies().isEmpty();
    }

    /** Returns true if there may be surfaces that cut blended pictures. */
    public boolean meetsSurfaces() {
        return LightRequirements.hasSurfaces(level) || hasBodies() || mayShowCharacter();
    }

    /** Returns true if blended pictures fade in front of surfaces, for which they read the view's depth; plain output does without. */
    public boolean fadesAtSurfaces() {
        return output != Output.PLAIN && meetsSurfaces();
    }

    /** Returns false if the level's picture is one colour, for which nothing is drawn but the clear. */
    public boolean drawsSomething() {
        Sky sky = level.environment().sky();
        return meetsSurfaces()
                || !level.exits().isEmpty()
                || !level.emitters().isEmpty()
                || !level.billboards().isEmpty()
                || level.environment().hasLightning()
                || !WeatherClouds.all(level.environment()).isEmpty()
                || sky instanceof Sky.Gradient
                || sky instanceof Sky.Skybox
                || SunAndMoon.lightAir(level.environment());
    }

    /** Returns true if frames are averaged: they then see different points of each pixel. */
    public boolean isAccumulated() {
        return quality.antialiasing() == Quality.Antialiasing.TEMPORAL && quality.samples() == 1 && drawsSomething();
    }

    /**
     * Returns true if the alpha of surfaces is the reciprocal of their distance along the view's axis, 0 for the sky and
     * negative for what moves on its own; otherwise it is 1, or the share that is metered.
     */
    public boolean storesDistance() {
        return isAccumulated() && !metersExposure();
    }

    /** Returns the alpha of pixels without a surface. */
    public double skyAlpha() {
        return storesDistance() ? 0 : 1;
    }

    /** Returns true if exposure is metered: for auto, from linear light. */
    public boolean metersExposure() {
        return output == Output.HDR && level.environment().exposureStops().isAuto();
    }

    /** Returns true if baked light is darkened near moving objects. */
    public boolean drawsContact() {
        return quality.contact() == Quality.Contact.ON
                && output != Output.PLAIN
                && lightMaps.bakes(LightMaps.Baked.BOUNCED)
                && (hasBodies() || mayShowCharacter());
    }

    public boolean mayShowCharacter() {
        return character == CharacterPresence.POSSIBLE;
    }
}
