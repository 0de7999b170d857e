package nephele.engine.render.frame;

import nephele.engine.level.Level;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.scene.dynamic.CharacterPresence;

/**
 * What the frames of a renderer are asked to show, and how: everything that a pass may depend on.
 *
 * @param lightMaps textures that the level's light is looked up in
 * @param figure whether a player's figure, and what it holds, can appear
 */
public record FrameRequest(Level level, LightMaps lightMaps, Output output, Quality quality, CharacterPresence figure) {
    /** @param statics that follow from the level */
    public static FrameRequest of(
            Level level, StaticShapes statics, Output output, Quality quality, CharacterPresence figure) {
        return new FrameRequest(level, LightMaps.of(level, statics, figure), output, quality, figure);
    }

    /** With quality HIGH and without a figure. */
    public static FrameRequest of(PlacedLevel placed, Output output) {
        return of(placed.level(), placed.statics(), output, Quality.HIGH, CharacterPresence.NEVER);
    }

    public boolean hasBodies() {
        return !level.bodies().isEmpty();
    }

    public boolean mayShowCharacter() {
        return figure == CharacterPresence.POSSIBLE;
    }
}
