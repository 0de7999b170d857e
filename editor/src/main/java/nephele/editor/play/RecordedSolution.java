package nephele.editor.play;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.DoubleConsumer;
import java.util.function.Supplier;
import nephele.engine.level.json.LevelFormatException;
import nephele.engine.sim.replay.Replay;
import nephele.engine.sim.state.SimLevel;
import nephele.host.named.LevelName;
import nephele.host.terminal.CommandFailure;

/** The recorded solution of a level, and its check in the background. */
public final class RecordedSolution {
    private RecordedSolution() {}

    /** Returns the file of a level's solution, which need not exist: {@code replays/x.json} beside {@code x.json}. */
    public static Path fileOf(Path level) {
        return new LevelName(level.toString()).solutionFile();
    }

    /** Returns true if a level has a recorded solution. */
    public static boolean isRecorded(Path level) {
        return Files.isRegularFile(fileOf(level));
    }

    /**
     * Receives the outcome of a check, on the check's thread; exactly one of the two, nothing after a cancellation.
     *
     * @param failed receives a message for the user: the solution cannot be read or the level not be simulated
     */
    public record Outcome(Consumer<SolutionVerdict> verdict, Consumer<String> failed) {}

    /** A check in progress. */
    public static final class Running {
        private volatile boolean isCancelled;

        private Running() {}

        /** Ends the check soon; its outcome is not told. */
        public void cancel() {
            isCancelled = true;
        }

        private DoubleConsumer until(DoubleConsumer progress) {
            return fraction -> {
                if (isCancelled) {
                    throw new CancellationException("the check was cancelled");
                }
                progress.accept(fraction);
            };
        }
    }

    /**
     * Starts to replay a level's solution in the present level on a thread of low priority.
     *
     * @param level the level's file, beside which the solution is
     * @param present gives the present level, on that thread
     * @param progress receives the completed share, 0–1, on that thread
     */
    public static Running check(Path level, Supplier<SimLevel> present, DoubleConsumer progress, Outcome outcome) {
        return check(level, present, progress, outcome, RecordedSolution::onThread);
    }

    /** Replays a solution as the other {@code check} does, by an executor. */
    public static Running check(
            Path level, Supplier<SimLevel> present, DoubleConsumer progress, Outcome outcome, Executor executor) {
        var running = new Running();
        executor.execute(() -> run(running, level, present, running.until(progress), outcome));
        return running;
    }

    private static void onThread(Runnable check) {
        var thread = new Thread(check, "solution");
        thread.setDaemon(true);
        thread.setPriority(Thread.MIN_PRIORITY);
        thread.start();
    }

    private static void run(
            Running running, Path level, Supplier<SimLevel> present, DoubleConsumer progress, Outcome outcome) {
        try {
            Optional<Replay> solution = isRecorded(level)
                    ? Optional.of(LevelName.replay(fileOf(level).toString()))
                    : Optional.empty();
            if (solution.isEmpty()) {
                outcome.failed().accept(fileOf(level) + ": there is no recorded solution: record one");
                return;
            }
            var verdict = SolutionCheck.of(present.get(), solution.get(), progress);
            if (!running.isCancelled) {
                outcome.verdict().accept(verdict);
            }
        } catch (CancellationException cancelled) {
            return;
        } catch (CommandFailure | LevelFormatException unusable) {
            outcome.failed().accept(unusable.getMessage());
        }
    }
}
