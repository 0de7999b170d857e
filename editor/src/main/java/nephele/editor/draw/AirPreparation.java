package nephele.editor.draw;

import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.function.DoubleConsumer;
import nephele.engine.level.Environment;
import nephele.engine.level.Level;
import nephele.engine.level.Sky;
import nephele.engine.level.appearance.AirCache;
import nephele.engine.level.appearance.Daylight;

/**
 * The light of a sky's air, which takes seconds to compute, prepared in the background: until it is ready, the sky has
 * the air that was ready last.
 */
final class AirPreparation implements AutoCloseable {
    private final AirStore store;
    private final Executor background;
    private final Runnable whenReady;
    private Sky.Atmosphere ready = Sky.Atmosphere.CLEAR;
    private Sky.Atmosphere coming;
    private CompletableFuture<Void> running;
    private Level followed;
    private Level shown;
    private volatile boolean isClosed;

    /** The computed light of air. */
    interface AirStore {
        /** The user's cache folder. */
        AirStore OF_USER = new AirStore() {
            @Override
            public boolean has(Environment environment) {
                return AirCache.has(environment);
            }

            @Override
            public void prepare(Environment environment, DoubleConsumer progress) {
                AirCache.prepare(environment, progress);
            }
        };

        /** Returns true if the air of an environment can be drawn at once. */
        boolean has(Environment environment);

        /** Computes the light of an environment's air, in seconds. */
        void prepare(Environment environment, DoubleConsumer progress);
    }

    /** @param whenReady called on a thread of {@code background} */
    AirPreparation(AirStore store, Executor background, Runnable whenReady) {
        this.store = store;
        this.background = background;
        this.whenReady = whenReady;
    }

    /** Returns the level, or one with other air until its own is ready; the same one until that changes. */
    Level of(Level level) {
        boolean isDone = running != null && running.isDone();
        if (isDone) {
            // Air whose preparation failed is not tried again: drawing it tells why.
            ready = coming;
            running = null;
        }
        if (level != followed || isDone) {
            followed = level;
            shown = drawable(level);
        }
        return shown;
    }

    private Level drawable(Level level) {
        Environment environment = level.environment();
        if (!(environment.sky() instanceof Sky.Atmosphere sky)) {
            return level;
        }
        if (Daylight.air(sky).equals(Daylight.air(ready)) || store.has(environment)) {
            ready = sky;
            return level;
        }
        if (running == null) {
            coming = sky;
            running = CompletableFuture.runAsync(() -> store.prepare(environment, this::progress), background);
            running.whenComplete((nothing, failure) -> whenReady.run());
        }
        return level.with(environment.with(sky.withAirOf(ready)), level.lights());
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
