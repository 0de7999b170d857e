package nephele.engine.scene.light;

import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.DoubleConsumer;
import nephele.engine.level.appearance.AirCache;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.scene.light.bake.BakedLight;
import nephele.engine.scene.light.bake.IndirectLight;
import nephele.engine.scene.light.bake.LightCache;
import nephele.engine.scene.light.bake.LightMapLayout;
import nephele.engine.scene.light.bake.SkyVisibility;
import nephele.engine.scene.light.bake.SkyVisibilityFile;
import nephele.engine.work.SwingThread;

/** The baked light of the static geometry, read or computed before the scene because that may take seconds. */
public final class LevelLight {
    private LevelLight() {}

    /** Returns the light as {@link #of(PlacedLevel, DoubleConsumer, Consumer)} does; says nothing about light that is ignored. */
    public static BakedLight of(PlacedLevel placed, DoubleConsumer progress) {
        return of(placed, progress, stored -> {});
    }

    /**
     * Reads the light that was baked for the level, and the sky visibility, which it otherwise bakes and stores ({@link
     * LightCache}). May run on a thread of its own while the level is edited; {@link
     * nephele.engine.scene.Scene#edited} accepts the result then.
     *
     * @param progress receives the completed fraction of a bake, 0–1, from several threads; not called without a bake.
     *     An exception that it throws ends the bake, which stores nothing, and is rethrown here
     * @param report receives what was found of the level's own light, once
     * @return {@code null} if no light of the sky reaches anything and no light was baked
     */
    public static BakedLight of(PlacedLevel placed, DoubleConsumer progress, Consumer<StoredLight> report) {
        return with(visibility(placed, progress), placed, report);
    }

    /** Returns the light as {@link #of(PlacedLevel, DoubleConsumer)} does for a level whose own light was never baked. */
    public static BakedLight unbaked(PlacedLevel placed, DoubleConsumer progress) {
        SkyVisibility visibility = visibility(placed, progress);
        return visibility == null ? null : new BakedLight(visibility, null);
    }

    private static SkyVisibility visibility(PlacedLevel placed, DoubleConsumer progress) {
        SwingThread.refuse("the bake of a sky");
        AirCache.prepare(placed.level().environment(), progress);
        return isRequired(placed) ? LightCache.of(placed.assets()).of(baked(placed), progress) : null;
    }

    /** Returns the light if it was baked before; bakes nothing. */
    public static Optional<BakedLight> known(PlacedLevel placed) {
        if (!isRequired(placed)) {
            return Optional.ofNullable(with(null, placed, stored -> {}));
        }
        return LightCache.of(placed.assets()).known(baked(placed)).map(known -> with(known, placed, stored -> {}));
    }

    private static BakedLight with(SkyVisibility visibility, PlacedLevel placed, Consumer<StoredLight> report) {
        StoredLight stored = StoredLight.of(placed, visibility == null ? () -> layout(placed) : visibility::layout);
        report.accept(stored);
        if (stored.light() == null) {
            return visibility == null ? null : new BakedLight(visibility, null);
        }
        return of(placed, visibility, stored.light());
    }

    /**
     * Returns the light of a level that may have no visibility of the sky, but has a light map nevertheless.
     *
     * @param visibility {@code null} for none
     */
    public static BakedLight of(PlacedLevel placed, SkyVisibility visibility, IndirectLight indirect) {
        SkyVisibility seen = visibility == null
                ? SkyVisibility.even(baked(placed), LightRequirements.skyShines(placed.level()))
                : visibility;
        return new BakedLight(seen, indirect);
    }

    /** Returns what is found of the level's own light. */
    public static StoredLight stored(PlacedLevel placed) {
        return StoredLight.of(placed, () -> layout(placed));
    }

    private static LightMapLayout layout(PlacedLevel placed) {
        return LightMapLayout.of(baked(placed).solids());
    }

    /** Returns true if the level needs a visibility at all. */
    public static boolean isRequired(PlacedLevel placed) {
        return LightRequirements.skyVisibility(placed.level());
    }

    /** Returns true if the light was baked for the very geometry of this level. */
    public static boolean isOf(BakedLight light, PlacedLevel placed) {
        return SkyVisibilityFile.nameFor(light.statics()).equals(SkyVisibilityFile.nameFor(baked(placed)));
    }

    /** Returns the static geometry of a level as light is baked for it. */
    public static StaticShapes baked(PlacedLevel placed) {
        return placed.statics().split(SkyVisibility.MODEL_EDGE_METRES);
    }
}
