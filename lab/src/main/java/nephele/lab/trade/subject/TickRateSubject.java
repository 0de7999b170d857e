package nephele.lab.trade.subject;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import nephele.engine.level.Level;
import nephele.engine.level.json.LevelFile;
import nephele.engine.math.Vec3;
import nephele.engine.sim.Simulation;
import nephele.engine.sim.state.PlayerDimensions;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerInput.Action;
import nephele.engine.sim.state.SimSettings;
import nephele.engine.sim.state.SimState;
import nephele.lab.trade.CostMetric;
import nephele.lab.trade.ErrorMetric;
import nephele.lab.trade.Experiment;
import nephele.lab.trade.Judgement;
import nephele.lab.trade.Setting;
import nephele.lab.trade.Trade;

/**
 * The option {@code --ticks-per-second}. A walk is a function of time instead of ticks, so that every rate can run it: a
 * new move intent every half second, on a beat of the slowest rate.
 */
public final class TickRateSubject implements Experiment {
    static final int[] RATES = {30, 60, 120, 240};

    /** A tenth of the player's radius. */
    private static final double TENTH_OF_A_BODY_MM = 30;

    private static final String COURSE = "levels/samples/walking.json";
    private static final int EXACT_RATE = 960;
    private static final int WALKS = 40;
    private static final int WALK_SECONDS = 3;
    private static final int BEATS_PER_SECOND = 30;
    private static final int BEATS_PER_INTENT = 15;
    private static final int INTENTS = WALK_SECONDS * BEATS_PER_SECOND / BEATS_PER_INTENT;

    /** A multiple of every number of ticks in a beat, so that a turn divides evenly among them. */
    private static final int TURN_STEP_MILLIDEGREES = 32;

    public static final Trade TRADE = new Trade(
            "tickRate",
            new Trade.Text(
                    "Ticks a second",
                    "How often the simulation moves the player. Between ticks the picture is interpolated, so a low"
                        + " rate does not look rough; but landings, corners and stairs come a little early or late,"
                        + " and a walk ends a little elsewhere. Walks of three seconds, a new random wish every half"
                        + " second.",
                    "the same walks at 960 ticks a second, and with the height of a jump, v²/2g"),
            List.of(),
            Stream.of("30", "60", "120", "240")
                    .map(rate -> new Setting(rate, rate.equals("120") ? "the game's" : ""))
                    .toList(),
            2,
            new ErrorMetric("median deviation of a walk", "mm", 0.1, TENTH_OF_A_BODY_MM),
            List.of("deviation of the worst walk, mm", "jump too low by, mm"),
            new CostMetric("CPU a simulated second", "µs", 1e3, WALK_SECONDS, CostMetric.Clock.THREAD),
            null,
            site -> new TickRateSubject());

    private final Level course = LevelFile.open(COURSE).level();
    private final List<Simulation> simulations = new ArrayList<>();
    private final List<PlayerInput> timed = randomWalk(0);
    private List<List<Vec3>> exact;

    private TickRateSubject() {
        for (int rate : RATES) {
            simulations.add(simulation(rate));
        }
    }

    private Simulation simulation(int rate) {
        return new Simulation(course, SimSettings.DEFAULT.withTicksPerSecond(rate));
    }

    @Override
    public Judgement judge(int setting) {
        if (exact == null) {
            exact = walks(simulation(EXACT_RATE));
        }
        List<List<Vec3>> walked = walks(simulations.get(setting));
        double[] deviations = new double[WALKS];
        for (int walk = 0; walk < WALKS; walk++) {
            deviations[walk] = 1e3 * greatestDistance(exact.get(walk), walked.get(walk));
        }
        Arrays.sort(deviations);
        double apex = feet(simulations.get(setting), jump(), 1).stream()
                .mapToDouble(Vec3::y)
                .max()
                .orElseThrow();
        return Judgement.of(deviations[WALKS / 2], deviations[WALKS - 1], 1e3 * (PlayerDimensions.JUMP_METRES - apex));
    }

    private static List<List<Vec3>> walks(Simulation simulation) {
        List<List<Vec3>> walks = new ArrayList<>();
        for (int seed = 0; seed < WALKS; seed++) {
            walks.add(feetOnBeats(simulation, randomWalk(seed)));
        }
        return walks;
    }

    private static double greatestDistance(List<Vec3> a, List<Vec3> b) {
        double greatest = 0;
        for (int i = 0; i < a.size(); i++) {
            greatest = Math.max(greatest, a.get(i).toVector().distance(b.get(i).toVector()));
        }
        return greatest;
    }

    @Override
    public void run(int setting) {
        feetOnBeats(simulations.get(setting), timed);
    }

    /** Returns an input for each intent, whose turn is that of a beat. */
    private static List<PlayerInput> randomWalk(long seed) {
        var random = new SplittableRandom(seed);
        List<PlayerInput> walk = new ArrayList<>();
        for (int i = 0; i < INTENTS; i++) {
            int forward = random.nextInt(4) == 0 ? 0 : 100;
            int right = random.nextInt(3) == 0 ? random.nextInt(-1, 2) * 100 : 0;
            int turn = random.nextInt(-60, 61) * TURN_STEP_MILLIDEGREES;
            var input = PlayerInput.NONE.walking(forward, right).turning(turn, 0);
            walk.add(random.nextInt(3) == 0 ? input.holding(Action.JUMP) : input);
        }
        return walk;
    }

    /** Returns a walk that stands, jumps once and stands again. */
    private static List<PlayerInput> jump() {
        List<PlayerInput> walk = new ArrayList<>(Collections.nCopies(INTENTS, PlayerInput.NONE));
        walk.set(1, PlayerInput.NONE.holding(Action.JUMP));
        return walk;
    }

    private static List<Vec3> feetOnBeats(Simulation simulation, List<PlayerInput> walk) {
        return feet(simulation, walk, ticksPerBeat(simulation));
    }

    private static int ticksPerBeat(Simulation simulation) {
        return simulation.settings().ticksPerSecond() / BEATS_PER_SECOND;
    }

    /** Returns the positions of the feet after every so many ticks. */
    private static List<Vec3> feet(Simulation simulation, List<PlayerInput> walk, int ticks) {
        int ticksPerBeat = ticksPerBeat(simulation);
        List<Vec3> feet = new ArrayList<>();
        SimState state = simulation.start();
        for (PlayerInput intent : walk) {
            var input = intent.turning(intent.turnLeftMillidegrees() / ticksPerBeat, 0);
            for (int tick = 1; tick <= BEATS_PER_INTENT * ticksPerBeat; tick++) {
                state = simulation.step(state, input);
                if (tick % ticks == 0) {
                    feet.add(state.player().feet());
                }
            }
        }
        return feet;
    }
}
