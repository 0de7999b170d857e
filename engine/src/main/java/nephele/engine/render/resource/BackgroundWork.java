package nephele.engine.render.resource;

import nephele.engine.render.frame.SharedResource;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.ForkJoinWorkerThread;
import java.util.function.Supplier;
import nephele.engine.render.gl.GlObject;

/** Threads of one renderer that compute tables beside its frames, on all processors but one. They end with it. */
public final class BackgroundWork implements GlObject {
    public static final SharedResource<BackgroundWork> RESOURCE =
            SharedResource.of("background work", context -> context.own(new BackgroundWork()));

    private final ForkJoinPool threads = new ForkJoinPool(
            Math.max(1, Runtime.getRuntime().availableProcessors() - 1),
            pool -> {
                ForkJoinWorkerThread thread = ForkJoinPool.defaultForkJoinWorkerThreadFactory.newThread(pool);
                thread.setName("nephele-tables-" + thread.getPoolIndex());
                return thread;
            },
            null,
            false);

    /** Starts a computation; its parallel streams run on these threads too. */
    public <T> CompletableFuture<T> start(Supplier<T> work) {
        return CompletableFuture.supplyAsync(work, threads);
    }

    @Override
    public void close() {
        threads.shutdownNow();
    }
}
