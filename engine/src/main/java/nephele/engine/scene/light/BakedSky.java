package nephele.engine.scene.light;

import java.util.function.DoubleConsumer;
import nephele.engine.level.placed.PlacedLevel;

/** The step before a scene that may take seconds: how much of the sky what never moves sees. */
public final class BakedSky {
    private BakedSky() {}

    /**
     * Reads it where it was baked before, else bakes it and keeps it for the next time ({@link SkyVisibilityCache}). May
     * run on a thread of its own while the level is edited; {@link nephele.engine.scene.Scene#edited} takes the light then.
     *
     * @param progress the done fraction, 0–1, of a bake, heard from several threads; not called where none is due.
     *     What it throws ends the bake, which leaves nothing, and is thrown here
     * @return {@code null} where no light of the sky falls on anything
     */
    public static SkyVisibility of(PlacedLevel placed, DoubleConsumer progress) {
        if (!LightNeeds.skyVisibility(placed.level())) {
            return null;
        }
        return SkyVisibilityCache.of(placed.assets())
                .of(placed.statics().split(SkyVisibility.MODEL_EDGE_METRES), progress);
    }
}
