package nephele.lab.trade.subject;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import nephele.engine.level.Level;
import nephele.engine.level.json.LevelFile;
import nephele.engine.math.Vec3;
import nephele.engine.sim.Simulation;
import nephele.engine.sim.state.PlayerDimensions;
import nephele.engine.sim.state.SimSettings;
import nephele.lab.trade.CostMetric;
import nephele.lab.trade.ErrorMetric;
import nephele.lab.trade.Experiment;
import nephele.lab.trade.Judgement;
import nephele.lab.trade.Setting;
import nephele.lab.trade.Trade;

/** The option {@code --ticks-per-second}. */
public final class TickRateSubject implements Experiment {
    static final int[] RATES = {30, 60, 120, 240};

    /** A tenth of the player's radius. */
    private static final double TENTH_OF_A_BODY_MM = 30;

    private static final String COURSE = "levels/samples/walking.json";
    private static final int EXACT_RATE = 960;
    private static final int WALKS = 40;

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
            new CostMetric("CPU a simulated second", "µs", 1e3, ScriptedWalk.SECONDS, CostMetric.Clock.THREAD),
            null,
            site -> new TickRateSubject());

    private final Level course = LevelFile.open(COURSE).level();
    private final List<Simulation> simulations = new ArrayList<>();
    private final ScriptedWalk timed = ScriptedWalk.random(0);
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
        double apex = ScriptedWalk.jump().highest(simulations.get(setting));
        return Judgement.of(deviations[WALKS / 2], deviations[WALKS - 1], 1e3 * (PlayerDimensions.JUMP_METRES - apex));
    }

    private static List<List<Vec3>> walks(Simulation simulation) {
        List<List<Vec3>> walks = new ArrayList<>();
        for (int seed = 0; seed < WALKS; seed++) {
            walks.add(ScriptedWalk.random(seed).feet(simulation));
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
        timed.feet(simulations.get(setting));
    }
}
