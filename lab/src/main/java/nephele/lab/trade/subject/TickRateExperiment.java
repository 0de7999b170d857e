package nephele.lab.trade.subject;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import nephele.engine.level.Level;
import nephele.engine.level.LevelFile;
import nephele.engine.math.Vec3;
import nephele.engine.sim.PlayerBody;
import nephele.engine.sim.SimSettings;
import nephele.engine.sim.Simulation;
import nephele.lab.trade.Experiment;
import nephele.lab.trade.Judgement;

/** Walks over stairs, slopes and around corners of the sample that has all of them. */
final class TickRateExperiment implements Experiment {
    private static final String COURSE = "levels/samples/walking.json";
    private static final int EXACT_RATE = 960;
    private static final int WALKS = 40;

    private final Level course = LevelFile.open(COURSE).level();
    private final List<Simulation> simulations = new ArrayList<>();
    private final ScriptedWalk timed = ScriptedWalk.random(0);
    private List<List<Vec3>> exact;

    TickRateExperiment() {
        for (int rate : TickRateSubject.RATES) {
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
        return Judgement.of(deviations[WALKS / 2], deviations[WALKS - 1], 1e3 * (PlayerBody.JUMP_HEIGHT - apex));
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

    @Override
    public void close() {
        simulations.clear();
    }
}
