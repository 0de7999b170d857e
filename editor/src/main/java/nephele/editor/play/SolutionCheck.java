package nephele.editor.play;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Iterator;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import java.util.function.DoubleConsumer;
import java.util.function.Supplier;
import nephele.editor.play.SolutionVerdict.AtExit;
import nephele.editor.play.SolutionVerdict.Cause;
import nephele.editor.play.SolutionVerdict.Deviation;
import nephele.engine.level.json.LevelFormatException;
import nephele.engine.sim.Simulation;
import nephele.engine.sim.replay.Replay;
import nephele.engine.sim.replay.Replay.Waypoint;
import nephele.engine.sim.state.SimLevel;
import nephele.engine.sim.state.SimState;
import nephele.engine.sim.state.TickEvent;
import nephele.host.named.LevelName;
import nephele.host.terminal.CommandFailure;

/** Replays the recorded solution of a level without graphics and compares its path with the recorded one. */
public final class SolutionCheck {
    /** The greatest distance from the recorded path that does not count. */
    private static final double TOLERANCE_METRES = 0.01;

    private static final int PROGRESS_TICKS = 120;

    private final Replay solution;
    private final DoubleConsumer progress;
    private final Iterator<Waypoint> track;
    private Waypoint next;
    private int portals;
    private Optional<AtExit> exit = Optional.empty();
    private Optional<Deviation> deviation = Optional.empty();

    private SolutionCheck(Replay solution, DoubleConsumer progress) {
        this.solution = solution;
        this.progress = progress;
        track = solution.track().iterator();
        next = track.hasNext() ? track.next() : null;
    }

    /** Returns the file of a level's solution, which need not exist: {@code replays/x.json} beside {@code x.json}. */
    public static Path fileOf(Path level) {
        return new LevelName(level.toString()).solutionFile();
    }

    /**
     * Starts to replay a level's solution in the present level. Exactly one of the last two receives the outcome, on the
     * check's thread; neither after a cancellation.
     *
     * @param level the level's file, beside which the solution is
     * @param executor runs the check
     * @param present gives the present level, on the check's thread
     * @param progress receives the completed fraction, 0–1, on that thread
     * @param failed receives a message for the user: the solution cannot be read or the level not be simulated
     * @return ends the check soon
     */
    public static Runnable start(
            Path level,
            Executor executor,
            Supplier<SimLevel> present,
            DoubleConsumer progress,
            Consumer<SolutionVerdict> verdict,
            Consumer<String> failed) {
        AtomicBoolean isCancelled = new AtomicBoolean();
        DoubleConsumer untilCancelled = fraction -> {
            if (isCancelled.get()) {
                throw new CancellationException("the check was cancelled");
            }
            progress.accept(fraction);
        };
        executor.execute(() -> {
            try {
                Path file = fileOf(level);
                if (!Files.isRegularFile(file)) {
                    failed.accept(file + ": there is no recorded solution: record one");
                    return;
                }
                Replay solution = LevelName.replay(file.toString());
                SolutionVerdict result = of(present.get(), solution, untilCancelled);
                if (!isCancelled.get()) {
                    verdict.accept(result);
                }
            } catch (CancellationException cancelled) {
                return;
            } catch (CommandFailure | LevelFormatException unusable) {
                failed.accept(unusable.getMessage());
            }
        });
        return () -> isCancelled.set(true);
    }

    /**
     * Replays a solution to its end; of one without a track only the exit is compared.
     *
     * @param progress receives the completed fraction, 0–1, about once a simulated second; an exception that it throws,
     *     such as {@link CancellationException}, ends the check
     */
    public static SolutionVerdict of(SimLevel level, Replay solution, DoubleConsumer progress) {
        var check = new SolutionCheck(solution, progress);
        var simulation = new Simulation(level, solution.settings());
        SimState last = solution.play(simulation, check::ticked);
        return check.verdict(last);
    }

    private void ticked(SimState state) {
        if (state.tick() % PROGRESS_TICKS == 0) {
            progress.accept((double) state.tick() / solution.ticks());
        }
        portals += exit.isEmpty() ? Waypoint.opened(state).size() : 0;
        if (next != null && next.tick() == state.tick()) {
            compare(next, state);
            next = track.hasNext() ? track.next() : null;
        }
        boolean isEnd = state.world().trace().events().stream().anyMatch(TickEvent.ExitReached.class::isInstance);
        if (isEnd) {
            exit = Optional.of(new AtExit(state.tick(), seconds(state), portals));
        }
    }

    private void compare(Waypoint expected, SimState state) {
        if (deviation.isPresent()) {
            return;
        }
        boolean isElsewhere = state.player().feet().minus(expected.feet()).length() > TOLERANCE_METRES;
        boolean isRefused = !Waypoint.opened(state).containsAll(expected.opened());
        if (isElsewhere || isRefused) {
            Cause cause = isElsewhere ? Cause.ELSEWHERE : Cause.PORTAL_REFUSED;
            deviation = Optional.of(new Deviation(
                    cause, state.tick(), seconds(state), state.player().feet(), expected.feet()));
        }
    }

    private SolutionVerdict verdict(SimState last) {
        progress.accept(1);
        if (exit.isEmpty() && deviation.isEmpty()) {
            var feet = last.player().feet();
            deviation = Optional.of(new Deviation(Cause.EXIT_NOT_REACHED, last.tick(), seconds(last), feet, feet));
        }
        return new SolutionVerdict(exit, deviation);
    }

    private double seconds(SimState state) {
        return (double) state.tick() / solution.ticksPerSecond();
    }
}
