package nephele.editor.draw;

import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.function.BiConsumer;
import java.util.function.DoubleConsumer;
import java.util.function.Predicate;
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
    private final Predicate<Environment> isPrepared;
    private final BiConsumer<Environment, DoubleConsumer> prepare;
    private final Executor background;
    private final Runnable whenReady;
    private Sky.Atmosphere ready = Sky.Atmosphere.CLEAR;
    private Sky.Atmosphere coming;
    private CompletableFuture<Void> running;
    private Level followed;
    private Level prepared;
    private volatile boolean isClosed;

    /**
     * Creates a preparation of the light of air in the user's cache.
     *
     * @param whenReady called on a thread of {@code background}
     */
    AirPreparation(Executor background, Runnable whenReady) {
        this(AirCache::has, AirCache::prepare, background, whenReady);
    }

    /**
     * Creates a preparation of light that is kept elsewhere.
     *
     * @param isPrepared returns true if the air of an environment can be drawn at once
     * @param prepare computes the light of an environment's air, in seconds, and reports its progress
     */
    AirPreparation(
            Predicate<Environment> isPrepared,
            BiConsumer<Environment, DoubleConsumer> prepare,
            Executor background,
            Runnable whenReady) {
        this.isPrepared = isPrepared;
        this.prepare = prepare;
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
            prepared = drawable(level);
        }
        return prepared;
    }

    private Level drawable(Level level) {
        Environment environment = level.environment();
        if (!(environment.sky() instanceof Sky.Atmosphere sky)) {
            return level;
        }
        if (Daylight.air(sky).equals(Daylight.air(ready)) || isPrepared.test(environment)) {
            ready = sky;
            return level;
        }
        if (running == null) {
            coming = sky;
            running = CompletableFuture.runAsync(() -> prepare.accept(environment, this::progress), background);
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
