package nephele.workshop.prove.edits;

import java.util.List;
import nephele.engine.level.Level;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.scene.Scene;
import nephele.engine.scene.light.LightRequirements;
import nephele.engine.scene.light.bake.BakedLight;
import nephele.engine.scene.light.bake.LightCache;
import nephele.engine.scene.light.bake.SkyVisibility;
import nephele.engine.sim.state.SimLevel;

/** Everything that is derived from a level without OpenGL, as the editor keeps it. */
public record EditedTown(PlacedLevel placed, Scene scene, SimLevel simulated) {
    /** Bakes the sky's light; nothing is saved to disk. */
    public static BakedLight baked(PlacedLevel placed) {
        SkyVisibility visibility = new LightCache(placed.assets(), List.of())
                .of(placed.statics().split(SkyVisibility.MODEL_EDGE_METRES), done -> {});
        return new BakedLight(visibility, null);
    }

    /**
     * Derives everything anew, as loading a level does.
     *
     * @param baked for this level or an earlier one; used if the sky lights the level
     */
    static EditedTown of(PlacedLevel placed, BakedLight baked) {
        BakedLight light = LightRequirements.skyVisibility(placed.level()) ? baked : null;
        return new EditedTown(placed, Scene.of(placed, light), SimLevel.of(placed));
    }

    /** Derives everything for an edited level and reuses the parts that do not differ. */
    EditedTown edited(Level level, BakedLight baked) {
        PlacedLevel other = placed.edited(level);
        return new EditedTown(other, scene.edited(other, baked), simulated.edited(placed, other));
    }
}
