package nephele.workshop.prove.process;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.sim.Simulation;
import nephele.engine.sim.replay.Replay;
import nephele.engine.sim.replay.ReplayRecorder;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.SimLevel;
import nephele.engine.sim.state.SimSettings;
import nephele.host.named.LevelName;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/**
 * Plays replays in successive processes: interpreted, compiled in each way, on each installed Java. Four replays are of
 * ten minutes of walking, and one has a hundred crossings, with a portal that is moved and a cube that is carried.
 */
public final class JitMatrixProof implements Proof {
    /** A level with stairs, slopes, a slot, a crate and a column. */
    public static final String LEVEL = "levels/samples/walking.json";

    public static final String PORTALS_LEVEL = "levels/samples/portals.json";

    private static final Path PORTALS_REPLAY = Path.of("levels/samples/replays/portals.json");
    private static final int WALKS = 4;
    private static final int TICKS = 10 * 60 * 120;
    private static final int EVERY = 60;

    @Override
    public Claim claim() {
        return new Claim(
                "replay-hashes",
                "A replay gives the same hashes in every process, interpreted or compiled in any way, on every Java.",
                "replays",
                WALKS + 1,
                1);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) throws Exception {
        List<String> failures = new ArrayList<>();
        List<JvmVariant> variants = JvmVariant.all();
        Path file = Files.createTempFile("nephele-replay", ".json");
        long ticks = 0;
        try {
            for (long unit = from; unit < from + count; unit++) {
                Replay replay = unit < WALKS ? wandering(unit, TICKS) : throughPortals();
                Files.writeString(file, replay.write());
                compare(unit, file, replay.ticks(), variants, failures);
                ticks += replay.ticks();
                progress.unitsDone(unit + 1 - from);
            }
        } finally {
            Files.delete(file);
        }
        List<Figure> figures = List.of(
                Figure.greatest("kinds of process", variants.size(), ""),
                Figure.sum("ticks in each", (double) ticks, ""));
        return ProofResult.of(count, failures, figures);
    }

    /** Returns the recorded replay. */
    public static Replay throughPortals() throws IOException {
        return Replay.read(PORTALS_REPLAY.toString(), Files.readAllBytes(PORTALS_REPLAY));
    }

    private static void compare(long unit, Path file, long ticks, List<JvmVariant> variants, List<String> failures)
            throws IOException, InterruptedException {
        String level = unit < WALKS ? LEVEL : PORTALS_LEVEL;
        long linesDue = (ticks + EVERY - 1) / EVERY;
        List<String> expected = null;
        for (JvmVariant variant : variants) {
            List<String> lines = hashesOfProcess(variant, level, file, EVERY);
            expected = expected == null ? lines : expected;
            if (lines.size() != linesDue || !lines.equals(expected)) {
                failures.add("replay " + unit + ", " + variant + ": differs at line " + difference(expected, lines));
            }
        }
    }

    private static int difference(List<String> a, List<String> b) {
        int line = 0;
        while (line < Math.min(a.size(), b.size()) && a.get(line).equals(b.get(line))) {
            line++;
        }
        return line + 1;
    }

    /**
     * Returns a replay of a player that walks, runs, jumps, crouches and looks around at random, with changes of mouse
     * and keys like a person's.
     */
    public static Replay wandering(long seed, int ticks) {
        var random = new SplittableRandom(seed);
        var recorder = new ReplayRecorder("walking.json", SimSettings.DEFAULT, null);
        for (int done = 0; done < ticks; ) {
            int stretch = Math.min(ticks - done, random.nextInt(1, 90));
            PlayerInput held = new PlayerInput(
                    random.nextInt(4) > 0 ? 100 : random.nextInt(-100, 101),
                    random.nextInt(-1, 2) * 100,
                    0,
                    0,
                    random.nextInt(3) > 0 ? random.nextInt(2) : random.nextInt(8));
            boolean looks = random.nextBoolean();
            for (int i = 0; i < stretch; i++) {
                recorder.record(looks ? held.turning(random.nextInt(-3000, 3001), random.nextInt(-900, 901)) : held);
            }
            done += stretch;
        }
        return recorder.replay();
    }

    /**
     * Plays a replay and prints a line {@code tick hash} every so many ticks.
     *
     * @param arguments level, replay, ticks between two lines
     */
    public static void main(String[] arguments) {
        var opened = new LevelName(arguments[0]).open();
        var replay = LevelName.replay(arguments[1]);
        var level = SimLevel.of(opened.placed());
        var hashes = Replay.hashes(Integer.parseInt(arguments[2]), replay.ticks(), System.out::println);
        replay.play(new Simulation(level, replay.settings()), hashes);
    }

    /**
     * Plays a replay in a process of its own and returns the lines {@code tick hash} that it prints.
     *
     * @param every ticks between two lines
     * @throws IOException with the error output of the process if it fails
     */
    public static List<String> hashesOfProcess(JvmVariant variant, String level, Path replay, int every)
            throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(List.of(variant.java().toString(), "-Xmx256m"));
        command.addAll(variant.flags());
        command.addAll(List.of("-cp", System.getProperty("java.class.path"), JitMatrixProof.class.getName()));
        command.addAll(List.of(level, replay.toString(), Integer.toString(every)));
        Path errors = Files.createTempFile("nephele-replay", ".txt");
        try {
            Process process =
                    new ProcessBuilder(command).redirectError(errors.toFile()).start();
            process.getOutputStream().close();
            String text = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
            if (process.waitFor() != 0) {
                throw new IOException(variant + ": " + Files.readString(errors));
            }
            return text.lines().toList();
        } finally {
            Files.delete(errors);
        }
    }
}
