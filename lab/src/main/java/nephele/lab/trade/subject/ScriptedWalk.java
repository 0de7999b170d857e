package nephele.lab.trade.subject;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.math.Vec3;
import nephele.engine.sim.Simulation;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerInput.Action;
import nephele.engine.sim.state.SimState;

/**
 * A player's input as a function of time instead of ticks, so that every tick rate can run it: a new move intent every
 * half second, on a beat of the slowest rate.
 */
final class ScriptedWalk {
    static final int SECONDS = 3;
    private static final int BEATS_PER_SECOND = 30;
    private static final int BEATS_PER_INTENT = 15;

    /** A multiple of every number of ticks in a beat, so that a turn divides evenly among them. */
    private static final int TURN_STEP_MILLIDEGREES = 32;

    private final List<Wish> wishes = new ArrayList<>();

    /** @param turnMillidegrees to the left, a beat */
    private record Wish(int forward, int right, int turnMillidegrees, boolean jumps) {}

    static ScriptedWalk random(long seed) {
        var random = new SplittableRandom(seed);
        var walk = new ScriptedWalk();
        for (int i = 0; i < SECONDS * BEATS_PER_SECOND / BEATS_PER_INTENT; i++) {
            walk.wishes.add(new Wish(
                    random.nextInt(4) == 0 ? 0 : 100,
                    random.nextInt(3) == 0 ? random.nextInt(-1, 2) * 100 : 0,
                    random.nextInt(-60, 61) * TURN_STEP_MILLIDEGREES,
                    random.nextInt(3) == 0));
        }
        return walk;
    }

    /** Returns a walk that stands, jumps once and stands again. */
    static ScriptedWalk jump() {
        var walk = new ScriptedWalk();
        for (int i = 0; i < SECONDS * BEATS_PER_SECOND / BEATS_PER_INTENT; i++) {
            walk.wishes.add(new Wish(0, 0, 0, i == 1));
        }
        return walk;
    }

    /** Returns the positions of the feet after every beat. */
    List<Vec3> feet(Simulation simulation) {
        int ticksPerBeat = simulation.settings().ticksPerSecond() / BEATS_PER_SECOND;
        List<Vec3> feet = new ArrayList<>();
        SimState state = simulation.start();
        for (Wish intent : wishes) {
            var input = input(intent, ticksPerBeat);
            for (int tick = 1; tick <= BEATS_PER_INTENT * ticksPerBeat; tick++) {
                state = simulation.step(state, input);
                if (tick % ticksPerBeat == 0) {
                    feet.add(state.player().feet());
                }
            }
        }
        return feet;
    }

    /** Returns the greatest height of the feet in any tick, in metres. */
    double highest(Simulation simulation) {
        int ticksPerBeat = simulation.settings().ticksPerSecond() / BEATS_PER_SECOND;
        SimState state = simulation.start();
        double highest = Double.NEGATIVE_INFINITY;
        for (Wish intent : wishes) {
            var input = input(intent, ticksPerBeat);
            for (int tick = 0; tick < BEATS_PER_INTENT * ticksPerBeat; tick++) {
                state = simulation.step(state, input);
                highest = Math.max(highest, state.player().feet().y());
            }
        }
        return highest;
    }

    private static PlayerInput input(Wish intent, int ticksPerBeat) {
        var input = PlayerInput.NONE
                .walking(intent.forward, intent.right)
                .turning(intent.turnMillidegrees / ticksPerBeat, 0);
        return intent.jumps ? input.holding(Action.JUMP) : input;
    }
}
