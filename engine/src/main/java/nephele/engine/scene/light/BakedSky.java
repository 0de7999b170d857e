package nephele.engine.scene.light;

import java.util.function.DoubleConsumer;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.scene.light.bake.SkyVisibility;
import nephele.engine.scene.light.bake.SkyVisibilityCache;

/** The sky visibility of the static geometry, computed before the scene because it may take seconds. */
public final class BakedSky {
    private BakedSky() {}

    /**
     * Reads the visibility if it was baked before, otherwise bakes and stores it ({@link SkyVisibilityCache}). May run
     * on a thread of its own while the level is edited; {@link nephele.engine.scene.Scene#edited} accepts the result
     * then.
     *
     * @param progress receives the completed fraction of a bake, 0–1, from several threads; not called without a bake.
     *     An exception that it throws ends the bake, which stores nothing, and is rethrown here
     * @return {@code null} if no light of the sky reaches anything
     */
    public static SkyVisibility of(PlacedLevel placed, DoubleConsumer progress) {
        if (!LightRequirements.skyVisibility(placed.level())) {
            return null;
        }
        return SkyVisibilityCache.of(placed.assets())
                .of(placed.statics().split(SkyVisibility.MODEL_EDGE_METRES), progress);
    }
}
