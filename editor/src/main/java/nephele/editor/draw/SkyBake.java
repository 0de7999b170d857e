package nephele.editor.draw;

import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.Executor;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.scene.light.BakedSky;
import nephele.engine.scene.light.LightRequirements;
import nephele.engine.scene.light.bake.SkyVisibility;

/** The sky's light of an edited level, baked in the background; until it is ready, that of an earlier version. */
final class SkyBake implements AutoCloseable {
    private final Executor background;
    private final Runnable whenReady;
    private StaticShapes started;
    private CompletableFuture<SkyVisibility> running;
    private SkyVisibility latest;
    private volatile boolean isClosed;

    /** @param whenReady called on a thread of {@code background} */
    SkyBake(Executor background, Runnable whenReady) {
        this.background = background;
        this.whenReady = whenReady;
    }

    /** Returns the last visibility that is ready; {@code null} for none. */
    SkyVisibility latest() {
        if (running != null && running.isDone()) {
            latest = result(running);
            running = null;
        }
        return latest;
    }

    /** Returns the earlier visibility if a bake fails: a picture with old light is better than none. */
    private SkyVisibility result(CompletableFuture<SkyVisibility> done) {
        try {
            return done.join();
        } catch (CompletionException | CancellationException failed) {
            return latest;
        }
    }

    /** Starts a bake if the sky lights the level, its shapes differ from the last ones, and none runs. */
    void follow(PlacedLevel placed) {
        boolean isNew = placed.statics() != started && LightRequirements.skyVisibility(placed.level());
        if (isNew && running == null) {
            started = placed.statics();
            running = CompletableFuture.supplyAsync(() -> BakedSky.of(placed, this::progress), background);
            running.whenComplete((visibility, failure) -> whenReady.run());
        }
    }

    private void progress(double done) {
        if (isClosed) {
            throw new CancellationException();
        }
    }

    @Override
    public void close() {
        isClosed = true;
    }
}
