package nephele.workshop.prove.bodies;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Supplier;
import nephele.engine.level.Level;
import nephele.engine.math.Vec3;
import nephele.engine.sim.Simulation;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.SimLevel;
import nephele.engine.sim.state.SimSettings;
import nephele.engine.sim.state.SimState;
import nephele.workshop.art.bench.BenchBodies;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/**
 * A tower and a stack of boxes remain standing, and moving a body allocates at most 256 B a tick. The CPU time of these
 * and of bodies that never rest is measured but not part of the claim.
 */
public final class BodiesProof implements Proof {
    private static final double TICKS_A_SECOND = 120;
    private static final double TOWER_METRES = 0.005;
    private static final double TOWER_DEGREES = 0.5;
    private static final double STACK_METRES = 0.05;
    private static final double STACK_SECONDS = 10;
    /** The limits of time refer to the first 300 steps of 1/60 s. */
    private static final int TIMED_TICKS = 600;

    private static final int WARM_ROUNDS = 6;

    private static final double MOST_BYTES_PER_BODY_AND_TICK = 256;
    private static final Vec3 BESIDE_STACK = new Vec3(8, 0, 0);
    /** A place on the floor slab outside the shaft's east wall. */
    private static final Vec3 BESIDE_SHAFT = new Vec3(6.4, 0, 0);

    @Override
    public Claim claim() {
        return new Claim(
                "bodies",
                "A tower of ten boxes stays within 5 mm and half a degree of its place for a minute; after ten seconds"
                    + " 500 boxes lie within 5 cm of where closing their gaps downwards puts them; a body allocates at"
                    + " most 256 B a tick.",
                "seconds",
                60,
                60);
    }

    /** Runs the tower for {@code count} seconds and the stack for at most ten; the units start at 0. */
    @Override
    public ProofResult run(long from, long count, Progress progress) {
        List<String> failures = new ArrayList<>();
        List<Figure> figures = new ArrayList<>();
        tower(count, failures, figures);
        progress.unitsDone(count / 2);
        stack(Math.min(STACK_SECONDS, count), failures, figures);
        costs(count, failures, figures);
        progress.unitsDone(count);
        return ProofResult.of(count, failures, figures);
    }

    private static void tower(long seconds, List<String> failures, List<Figure> figures) {
        var bodies = BodyRun.tower(10);
        for (long tick = 0; tick < seconds * TICKS_A_SECOND; tick++) {
            bodies.tick(1 / TICKS_A_SECOND);
            if (failures.isEmpty() && !(bodies.farthestOff() <= TOWER_METRES && bodies.mostTilted() <= TOWER_DEGREES)) {
                failures.add(String.format(
                        Locale.ROOT,
                        "tick %d of the tower: %.6f m and %.3f degrees off",
                        tick,
                        bodies.farthestOff(),
                        bodies.mostTilted()));
            }
        }
        figures.add(Figure.greatest("tower, farthest from its place", bodies.farthestOff() * 1000, "mm"));
        figures.add(Figure.greatest("tower, most tilted", bodies.mostTilted(), "degrees"));
    }

    private static void stack(double seconds, List<String> failures, List<Figure> figures) {
        var bodies = BodyRun.stack();
        for (int tick = 0; tick < seconds * TICKS_A_SECOND; tick++) {
            bodies.tick(1 / TICKS_A_SECOND);
        }
        if (seconds == STACK_SECONDS && !(bodies.farthestOff() <= STACK_METRES)) {
            failures.add(String.format(Locale.ROOT, "a box of the stack is %.6f m off", bodies.farthestOff()));
        }
        figures.add(Figure.greatest("stack, farthest from its place", bodies.farthestOff() * 1000, "mm"));
    }

    private static void costs(long seconds, List<String> failures, List<Figure> figures) {
        int ticks = (int) Math.min(TIMED_TICKS, seconds * TICKS_A_SECOND);
        Level stack = BenchBodies.stack(BodyRun.DARK);
        Level shaft = BenchBodies.shaft(BodyRun.DARK);
        double ofStack = measure("stack of 500", () -> moved(BodyRun.stack()), stack, ticks, figures);
        double ofShaft = measure("200 without rest", () -> moved(BodyRun.restless()), shaft, ticks, figures);
        measure("stack of 500, whole simulation", () -> played(stack, BESIDE_STACK), stack, ticks, figures);
        measure("200 without rest, whole simulation", () -> played(shaft, BESIDE_SHAFT), shaft, ticks, figures);
        for (double bytes : List.of(ofStack, ofShaft)) {
            if (!(bytes <= MOST_BYTES_PER_BODY_AND_TICK)) {
                failures.add("a body allocates " + bytes + " B a tick");
            }
        }
    }

    /**
     * Measures the costs of bodies for the simulating thread, after warm-up, and returns the bytes that a body allocates
     * in a tick.
     *
     * @param runs creates a run from its start: the code that advances its bodies by a tick
     * @param level of the bodies
     */
    private static double measure(String name, Supplier<Runnable> runs, Level level, int ticks, List<Figure> figures) {
        for (int round = 0; round < WARM_ROUNDS; round++) {
            repeat(runs.get(), ticks);
        }
        Runnable tick = runs.get();
        var thread = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long bytes = thread.getCurrentThreadAllocatedBytes();
        long nanos = thread.getCurrentThreadCpuTime();
        repeat(tick, ticks);
        nanos = thread.getCurrentThreadCpuTime() - nanos;
        bytes = thread.getCurrentThreadAllocatedBytes() - bytes;
        double bytesPerBodyAndTick = (double) bytes / ticks / level.bodies().size();
        figures.add(Figure.greatest(name + ", CPU per two ticks", nanos / 1e6 / ticks * 2, "ms"));
        figures.add(Figure.greatest(name + ", allocated a body and tick", bytesPerBodyAndTick, "B"));
        return bytesPerBodyAndTick;
    }

    private static void repeat(Runnable tick, int ticks) {
        for (int i = 0; i < ticks; i++) {
            tick.run();
        }
    }

    private static Runnable moved(BodyRun bodies) {
        return () -> bodies.tick(1 / TICKS_A_SECOND);
    }

    /** Returns a run in which a tick is a whole tick of the simulation, with an idle player. */
    private static Runnable played(Level level, Vec3 feet) {
        var simulation = new Simulation(SimLevel.of(level), new SimSettings((int) TICKS_A_SECOND, List.of()));
        SimState start = simulation.start();
        SimState[] state = {start.withPlayer(start.player().withFeet(feet))};
        return () -> state[0] = simulation.step(state[0], PlayerInput.NONE);
    }
}
