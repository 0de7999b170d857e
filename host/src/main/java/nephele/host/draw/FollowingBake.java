package nephele.host.draw;

import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.function.Supplier;
import nephele.engine.asset.AssetException;
import nephele.engine.level.json.LevelFile;
import nephele.engine.level.json.LevelFormatException;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.scene.Scene;
import nephele.engine.scene.light.LevelLight;
import nephele.engine.scene.light.bake.BakedLight;
import nephele.host.named.LevelName;

/**
 * A bake of a level's light while the level is drawn already, as if nothing hid the sky. Its scene then replaces the
 * one that is drawn.
 */
public final class FollowingBake implements AutoCloseable {
    private final FutureTask<Scene> task;
    private volatile int percent;
    private volatile boolean isClosed;

    private FollowingBake(Scene scene, PlacedLevel drawn) {
        task = new FutureTask<>(() -> scene.light() == null || LevelLight.isOf(scene.light(), drawn)
                ? scene
                : scene.edited(drawn, LevelLight.of(drawn, this::progress)));
    }

    /**
     * Returns the light of a level before its bake: the stored one, else the former, else that of an open sky.
     *
     * @param former of an earlier state of the level, {@code null} for none
     * @return {@code null} if no light of the sky reaches anything and no light was baked
     */
    static BakedLight lightBefore(PlacedLevel placed, Supplier<BakedLight> former) {
        Optional<BakedLight> known = LevelLight.known(placed);
        if (known.isPresent() || !LevelLight.isRequired(placed)) {
            return known.orElse(null);
        }
        return Optional.ofNullable(former.get()).orElseGet(BakedLight::open);
    }

    /** Returns the baked light of a level as saved; empty if it was not baked, or the level cannot be read. */
    public static Optional<BakedLight> lightOf(LevelName level) {
        try {
            var saved = LevelFile.open(level.typed());
            return LevelLight.known(PlacedLevel.of(saved.level(), saved.assets()));
        } catch (LevelFormatException | AssetException unusable) {
            return Optional.empty();
        }
    }

    /**
     * Starts the bake, if the scene needs one, on a thread of its own.
     *
     * @param drawn the level of the scene
     */
    public static FollowingBake begin(Scene scene, PlacedLevel drawn) {
        var bake = new FollowingBake(scene, drawn);
        var thread = new Thread(bake.task, "bake");
        thread.setDaemon(true);
        thread.start();
        return bake;
    }

    private void progress(double fraction) {
        if (isClosed) {
            throw new CancellationException("the level is drawn no more");
        }
        percent = Math.max(percent, (int) (100 * fraction));
    }

    /** Returns true if {@link #scene} would not wait. */
    public boolean isDone() {
        return task.isDone();
    }

    /** Returns how much of the light is baked, percent. */
    public int percent() {
        return percent;
    }

    /** Returns the scene with baked light, the same one if it had that; rethrows a failure of the bake. */
    public Scene scene() {
        try {
            return task.get();
        } catch (ExecutionException failure) {
            throw failure.getCause() instanceof RuntimeException known
                    ? known
                    : new IllegalStateException(failure.getCause());
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("interrupted while light was baked", interrupted);
        }
    }

    /** Ends the bake soon; nothing is stored then. */
    @Override
    public void close() {
        isClosed = true;
    }
}
