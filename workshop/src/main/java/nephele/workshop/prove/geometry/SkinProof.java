package nephele.workshop.prove.geometry;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import nephele.engine.collision.CollisionWorld;
import nephele.engine.collision.Sweep;
import nephele.engine.level.PlayerStart;
import nephele.engine.math.Vec3;
import nephele.engine.sim.Simulation;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.SimSettings;
import nephele.engine.sim.state.SimState;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/** Walks among slot, wedge, stairs and needles and measures the distance of the nearest solid after every tick. */
public final class SkinProof implements Proof {
    private static final int TICKS_PER_WALK = 1000;
    private static final int TICKS_PER_INPUT = 24;
    /** The part of the skin that rounding may use up. */
    private static final double ALLOWED_METRES = 1e-6;

    @Override
    public Claim claim() {
        return new Claim(
                "player-skin",
                "In slot, wedge, stairs and needles the player keeps its 1 mm from every solid, measured by brute"
                        + " force.",
                "walks of 1000 moves",
                1000,
                200);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) {
        CollisionWorld world = ObstacleCourse.at(Vec3.ZERO);
        var simulation = new Simulation(world, new PlayerStart(Vec3.ZERO, 0, 0), SimSettings.DEFAULT);
        List<String> failures = new ArrayList<>();
        double least = Double.POSITIVE_INFINITY;
        for (long unit = from; unit < from + count; unit++) {
            double gap = nearestOf(unit, simulation, world);
            least = Math.min(least, gap);
            if (!(gap >= Sweep.SKIN_METRES - ALLOWED_METRES)) {
                failures.add(String.format(Locale.ROOT, "walk %d: %.9f m from a solid", unit, gap));
            }
            progress.unitsDone(unit + 1 - from);
        }
        List<Figure> figures = List.of(
                Figure.sum("moves", (double) count * TICKS_PER_WALK, ""),
                Figure.least("least distance from a solid", least * 1000, "mm"));
        return ProofResult.of(count, failures, figures);
    }

    private static double nearestOf(long unit, Simulation simulation, CollisionWorld world) {
        var random = new SplittableRandom(unit);
        SimState state = simulation.start();
        PlayerInput input = PlayerInput.NONE;
        double least = Double.POSITIVE_INFINITY;
        for (int tick = 0; tick < TICKS_PER_WALK; tick++) {
            input = tick % TICKS_PER_INPUT == 0 ? ObstacleCourse.anything(random) : input;
            state = simulation.step(state, input);
            double gap = state.faults() == 0 ? BruteForce.gap(state.player(), world) : Double.NaN;
            least = gap >= least ? least : gap;
        }
        return least;
    }
}
