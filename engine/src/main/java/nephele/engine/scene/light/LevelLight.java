package nephele.engine.scene.light;

import java.util.Optional;
import java.util.function.DoubleConsumer;
import nephele.engine.level.appearance.AirCache;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.scene.light.bake.BakedLight;
import nephele.engine.scene.light.bake.SkyVisibility;
import nephele.engine.scene.light.bake.SkyVisibilityCache;
import nephele.engine.scene.light.bake.SkyVisibilityFile;
import nephele.engine.work.SwingThread;

/** The baked light of the static geometry, read or computed before the scene because that may take seconds. */
public final class LevelLight {
    private LevelLight() {}

    /**
     * Reads the sky visibility if it was baked before, otherwise bakes and stores it ({@link SkyVisibilityCache}). May run
     * on a thread of its own while the level is edited; {@link nephele.engine.scene.Scene#edited} accepts the result
     * then.
     *
     * @param progress receives the completed fraction of a bake, 0–1, from several threads; not called without a bake.
     *     An exception that it throws ends the bake, which stores nothing, and is rethrown here
     * @return {@code null} if no light of the sky reaches anything
     */
    public static BakedLight of(PlacedLevel placed, DoubleConsumer progress) {
        SwingThread.refuse("the bake of a sky");
        AirCache.prepare(placed.level().environment(), progress);
        if (!LightRequirements.skyVisibility(placed.level())) {
            return null;
        }
        return new BakedLight(SkyVisibilityCache.of(placed.assets()).of(baked(placed), progress), null);
    }

    /** Returns the light if it was baked before; bakes nothing. */
    public static Optional<BakedLight> known(PlacedLevel placed) {
        return SkyVisibilityCache.of(placed.assets()).known(baked(placed)).map(known -> new BakedLight(known, null));
    }

    /** Returns true if the level needs a visibility at all. */
    public static boolean isRequired(PlacedLevel placed) {
        return LightRequirements.skyVisibility(placed.level());
    }

    /** Returns true if the light was baked for the very geometry of this level. */
    public static boolean isOf(BakedLight light, PlacedLevel placed) {
        return SkyVisibilityFile.nameFor(light.statics()).equals(SkyVisibilityFile.nameFor(baked(placed)));
    }

    private static StaticShapes baked(PlacedLevel placed) {
        return placed.statics().split(SkyVisibility.MODEL_EDGE_METRES);
    }
}
