package nephele.app.prove;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.sim.PlayerInput;
import nephele.engine.sim.Replay;
import nephele.engine.sim.ReplayRecorder;
import nephele.engine.sim.SimSettings;

/** Plays ten-minute replays in one process after the other: interpreted, compiled in each way, on each Java there is. */
public final class JitMatrixProof implements Proof {
    /** Has stairs, slopes, a slot, a crate and a column. */
    public static final String LEVEL = "levels/samples/walking.json";

    private static final int TICKS = 10 * 60 * 120;
    private static final int EVERY = 60;

    @Override
    public String name() {
        return "replay-hashes";
    }

    @Override
    public String claim() {
        return "A replay gives the same hashes in every process, interpreted or compiled in any way, on every Java.";
    }

    @Override
    public String unit() {
        return "replays of 10 minutes";
    }

    @Override
    public long fullCount() {
        return 4;
    }

    @Override
    public long batch() {
        return 1;
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) throws Exception {
        List<String> failures = new ArrayList<>();
        List<JvmVariant> variants = JvmVariant.all();
        Path file = Files.createTempFile("nephele-replay", ".json");
        try {
            for (long unit = from; unit < from + count; unit++) {
                Files.writeString(file, wandering(unit, TICKS).write());
                compare(unit, file, variants, failures);
                progress.unitsDone(unit + 1 - from);
            }
        } finally {
            Files.delete(file);
        }
        List<Figure> figures = List.of(
                Figure.greatest("kinds of process", variants.size(), ""),
                Figure.sum("ticks in each", (double) TICKS * count, ""));
        return new ProofResult(count, failures.size(), figures, failures);
    }

    private static void compare(long unit, Path file, List<JvmVariant> variants, List<String> failures)
            throws IOException, InterruptedException {
        List<String> expected = null;
        for (JvmVariant variant : variants) {
            List<String> lines = new ReplayProcess(variant, LEVEL, file, EVERY).lines();
            expected = expected == null ? lines : expected;
            if (lines.size() != TICKS / EVERY || !lines.equals(expected)) {
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

    /** Someone who walks, runs, jumps, crouches and looks about at random, mouse and keys changing like a player's. */
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
}
