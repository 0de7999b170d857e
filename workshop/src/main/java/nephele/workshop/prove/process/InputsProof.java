package nephele.workshop.prove.process;

import com.sun.management.OperatingSystemMXBean;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.function.LongPredicate;
import java.util.stream.LongStream;
import nephele.engine.render.gl.GlContext;
import nephele.workshop.prove.process.InputTrial.Outcome;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/** Gives levels odd numbers and uses them; run it with {@code -Xmx512m}, so that one that needs more fails. */
public final class InputsProof implements Proof {
    private static final double MOST_CPU_SECONDS = 10;

    /** Time after which an input is told to hang, while it still does. */
    private static final double HANGING_CPU_SECONDS = 60;

    /** Levels whose skies take a second: one in {@link #SKIES_DRAWN} that is accepted is drawn, of others each. */
    private static final Set<String> SKIES = Set.of("air", "weather", "clouds");

    private static final int SKIES_DRAWN = 8;

    private final InputLevels levels = new InputLevels();
    private final OperatingSystemMXBean process = (OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();

    @Override
    public Claim claim() {
        return new Claim(
                "inputs",
                "A level with a number at zero, least, greatest, subnormal or just outside its range, alone and in"
                    + " pairs, is refused with its place, or it is saved and read back equal, explained, simulated and"
                    + " drawn at 64 × 36 without a pixel that is no number (of those with air, clouds or weather one"
                    + " in eight is drawn, its clouds explained); each takes at most 10 s of CPU.",
                "levels",
                100_000,
                500);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) throws Exception {
        return run(LongStream.range(from, from + count).toArray(), this::isDrawn, progress);
    }

    /** Runs some units and draws some of them. */
    ProofResult run(long[] units, LongPredicate drawn, Progress progress) throws Exception {
        Path folder = Files.createTempDirectory("nephele-inputs");
        List<String> failures = new ArrayList<>();
        Map<Outcome, Integer> outcomes = new EnumMap<>(Outcome.class);
        double longest = 0;
        String slowest = "";
        try (GlContext gl = GlContext.offscreen()) {
            InputLevels.writePictures(folder);
            InputTrial trial = new InputTrial(folder);
            for (int done = 0; done < units.length; done++) {
                long unit = units[done];
                InputLevels.OddInput input = levels.of(unit);
                String name = "level " + unit + ", " + input.reported();
                double before = cpuSeconds();
                Thread watch = watch(name, before, progress);
                Optional<String> fault = trial.run(input, drawn.test(unit) ? gl : null);
                watch.interrupt();
                double seconds = cpuSeconds() - before;
                outcomes.merge(trial.outcome(), 1, Integer::sum);
                fault.ifPresent(text -> add(name + ": " + text, failures, progress));
                if (seconds > MOST_CPU_SECONDS) {
                    add(name + ": takes " + seconds + " CPU-s", failures, progress);
                }
                if (seconds > longest) {
                    longest = seconds;
                    slowest = name;
                }
                progress.unitsDone(done + 1);
            }
        } finally {
            TemporaryFolder.delete(folder);
        }
        return ProofResult.of(
                units.length,
                failures,
                Figure.sum("refused", outcomes.getOrDefault(Outcome.REFUSED, 0), ""),
                Figure.sum("accepted", outcomes.getOrDefault(Outcome.ACCEPTED, 0), ""),
                Figure.sum("accepted and drawn", outcomes.getOrDefault(Outcome.DRAWN, 0), ""),
                Figure.greatest("longest", longest, "CPU-s, " + slowest));
    }

    private double cpuSeconds() {
        return process.getProcessCpuTime() / 1e9;
    }

    /** Tells of an input that never ends, until it is interrupted: the proof then has to be stopped by hand. */
    private Thread watch(String name, double before, Progress progress) {
        Thread watch = new Thread(() -> {
            try {
                do {
                    Thread.sleep(1000);
                } while (cpuSeconds() - before < HANGING_CPU_SECONDS);
                progress.failed(name + ": hangs");
            } catch (InterruptedException ended) {
                Thread.currentThread().interrupt();
            }
        });
        watch.setDaemon(true);
        watch.start();
        return watch;
    }

    private boolean isDrawn(long unit) {
        return !SKIES.contains(levels.of(unit).name())
                || new SplittableRandom(unit).split().nextInt(SKIES_DRAWN) == 0;
    }

    private static void add(String failure, List<String> failures, Progress progress) {
        failures.add(failure);
        progress.failed(failure);
    }
}
