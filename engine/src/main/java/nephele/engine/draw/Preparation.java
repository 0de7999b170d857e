package nephele.engine.draw;

import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.function.DoubleConsumer;
import nephele.engine.named.AssetComplaint;
import nephele.engine.named.LevelName;
import nephele.engine.named.OpenedLevel;
import nephele.engine.scene.Scene;
import nephele.engine.scene.light.BakedSky;
import nephele.engine.sim.SimLevel;

/** Reads a level and derives its scene on a thread of its own, while another one opens the window and its context. */
public final class Preparation {
    private final FutureTask<Prepared> task;

    /** A level that needs nothing but OpenGL to be drawn, and nothing more to be simulated. */
    public record Prepared(OpenedLevel opened, Scene scene, SimLevel world, long nanos) {}

    private Preparation(FutureTask<Prepared> task) {
        this.task = task;
    }

    /** @param bakeProgress hears 0–1 from several threads while light is baked, and nothing when it is not */
    public static Preparation begin(LevelName level, QualityChoice quality, DoubleConsumer bakeProgress) {
        var task = new FutureTask<>(() -> {
            long start = System.nanoTime();
            var opened = level.open();
            var shown = quality.shown(opened);
            var sky = BakedSky.of(shown, bakeProgress);
            var scene = AssetComplaint.named(opened, () -> Scene.of(shown, sky));
            return new Prepared(opened, scene, SimLevel.of(opened.placed()), System.nanoTime() - start);
        });
        var thread = new Thread(task, "level");
        thread.setDaemon(true);
        thread.start();
        return new Preparation(task);
    }

    public boolean isDone() {
        return task.isDone();
    }

    /** Waits; a failure is thrown here as it was there. */
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
