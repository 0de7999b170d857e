package nephele.workshop.prove.editor;

import java.awt.EventQueue;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import javax.swing.Timer;

/** Runs steps on the event dispatch thread, one at a time, and notices what throws or does not come back. */
final class WatchedEvents implements AutoCloseable {
    private static final long LONGEST_SECONDS = 60;
    private static final int WAKE_MILLIS = 200;
    private static final int FRAMES_TOLD = 12;

    /** An idle queue would end its thread, and with it the current OpenGL context. */
    private final Timer wake = new Timer(WAKE_MILLIS, tick -> {});

    private final List<Throwable> thrown = Collections.synchronizedList(new ArrayList<>());
    private Thread dispatcher;

    WatchedEvents() {
        wake.start();
    }

    /** Something to do on the event dispatch thread. */
    @FunctionalInterface
    interface Step {
        void run() throws Exception;
    }

    /** Runs a step; returns what went wrong in it or in what an earlier one had left to do later. */
    Optional<String> run(Step step) throws InterruptedException {
        FutureTask<Void> task = new FutureTask<>(() -> {
            dispatcher = Thread.currentThread();
            dispatcher.setUncaughtExceptionHandler((thread, uncaught) -> thrown.add(uncaught));
            step.run();
            return null;
        });
        EventQueue.invokeLater(task);
        try {
            task.get(LONGEST_SECONDS, TimeUnit.SECONDS);
        } catch (ExecutionException failed) {
            thrown.add(failed.getCause());
        } catch (TimeoutException late) {
            return Optional.of("no answer in " + LONGEST_SECONDS + " s: " + reported(dispatcher.getStackTrace()));
        }
        if (thrown.isEmpty()) {
            return Optional.empty();
        }
        Throwable first = thrown.get(0);
        thrown.clear();
        return Optional.of(first + " " + reported(first.getStackTrace()));
    }

    private static String reported(StackTraceElement[] stack) {
        List<String> frames = new ArrayList<>();
        for (int i = 0; i < Math.min(FRAMES_TOLD, stack.length); i++) {
            frames.add(stack[i].toString());
        }
        return String.join(" < ", frames);
    }

    @Override
    public void close() {
        wake.stop();
    }
}
