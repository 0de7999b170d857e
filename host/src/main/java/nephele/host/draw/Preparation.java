package nephele.host.draw;

import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.function.Consumer;
import java.util.function.DoubleConsumer;
import java.util.function.Function;
import java.util.function.Supplier;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.scene.Scene;
import nephele.engine.scene.light.bake.BakedLight;
import nephele.engine.sim.state.SimLevel;
import nephele.host.named.LevelName;
import nephele.host.named.OpenedLevel;

/** Reads a level and builds its scene on a separate thread, while another thread opens the window and its context. */
public final class Preparation {
    private final FutureTask<Prepared> task;

    /**
     * A level ready to be drawn with OpenGL and simulated.
     *
     * @param nanos duration of the preparation
     */
    public record Prepared(OpenedLevel opened, Scene scene, SimLevel world, long nanos) {
        /** Returns this with another scene of the same level. */
        public Prepared with(Scene other) {
            return new Prepared(opened, other, world, nanos);
        }
    }

    private Preparation(FutureTask<Prepared> task) {
        this.task = task;
    }

    /**
     * Starts the preparation of a level.
     *
     * @param bakeProgress called with 0–1 from several threads while light is baked, otherwise not
     * @param warnings receives a line if baked light is there and ignored
     */
    public static Preparation begin(
            LevelName level, QualityChoice quality, DoubleConsumer bakeProgress, Consumer<String> warnings) {
        return begin(level::open, quality, drawn -> quality.light(drawn, level.typed(), bakeProgress, warnings));
    }

    /**
     * Starts the preparation of a level without a bake: {@link FollowingBake} bakes its light while it is drawn.
     *
     * @param former gives the light of an earlier state of the level, {@code null} for none; called only if needed, on
     *     the thread of the preparation
     */
    public static Preparation beginUnbaked(
            Supplier<OpenedLevel> level, QualityChoice quality, Supplier<BakedLight> former) {
        return begin(level, quality, drawn -> FollowingBake.lightBefore(drawn, former));
    }

    private static Preparation begin(
            Supplier<OpenedLevel> level, QualityChoice quality, Function<PlacedLevel, BakedLight> light) {
        var task = new FutureTask<>(() -> {
            long start = System.nanoTime();
            var opened = level.get();
            var drawn = quality.drawn(opened);
            var sky = light.apply(drawn);
            var scene = opened.reporting(() -> Scene.of(drawn, sky));
            return new Prepared(opened, scene, SimLevel.of(opened.placed()), System.nanoTime() - start);
        });
        var thread = new Thread(task, "level");
        thread.setDaemon(true);
        thread.start();
        return new Preparation(task);
    }

    /** Returns true if {@link #get} would not wait. */
    public boolean isDone() {
        return task.isDone();
    }

    /** Waits for the result; rethrows a failure of the preparation. */
    public Prepared get() {
        try {
            return task.get();
        } catch (ExecutionException failure) {
            if (failure.getCause() instanceof RuntimeException known) {
                throw known;
            }
            if (failure.getCause() instanceof Error error) {
                throw error;
            }
            throw new IllegalStateException(failure.getCause());
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("interrupted while a level was read", interrupted);
        }
    }
}
