package nephele.engine.draw;

import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.function.DoubleConsumer;
import nephele.engine.named.AssetProblems;
import nephele.engine.named.LevelName;
import nephele.engine.named.OpenedLevel;
import nephele.engine.scene.Scene;
import nephele.engine.scene.light.BakedSky;
import nephele.engine.sim.state.SimLevel;

/** Reads a level and builds its scene on a separate thread, while another thread opens the window and its context. */
public final class Preparation {
    private final FutureTask<Prepared> task;

    /**
     * A level ready to be drawn with OpenGL and simulated.
     *
     * @param nanos duration of the preparation
     */
    public record Prepared(OpenedLevel opened, Scene scene, SimLevel world, long nanos) {}

    private Preparation(FutureTask<Prepared> task) {
        this.task = task;
    }

    /**
     * Starts the preparation of a level.
     *
     * @param bakeProgress called with 0–1 from several threads while light is baked, otherwise not
     */
    public static Preparation begin(LevelName level, QualityChoice quality, DoubleConsumer bakeProgress) {
        var task = new FutureTask<>(() -> {
            long start = System.nanoTime();
            var opened = level.open();
            var shown = quality.shown(opened);
            var sky = BakedSky.of(shown, bakeProgress);
            var scene = AssetProblems.named(opened, () -> Scene.of(shown, sky));
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
