package nephele.app.prove;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.locks.LockSupport;
import nephele.engine.level.Level;
import nephele.engine.level.LevelFile;
import nephele.engine.level.LevelFormatException;

/** Kills processes that save levels, at random moments, and reads what they left. */
public final class SaveKillProof implements Proof {
    /** About two saves long, so that every step of one is met. */
    private static final long LONGEST_WAIT_NANOS = 12_000_000;

    private static final int MOST_SAVES_BEFORE = 3;

    @Override
    public String name() {
        return "save-kills";
    }

    @Override
    public String claim() {
        return "Killing the process at any moment of a save leaves a complete old or new level file.";
    }

    @Override
    public String unit() {
        return "kills";
    }

    @Override
    public long fullCount() {
        return 1_000;
    }

    @Override
    public long batch() {
        return 100;
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) throws Exception {
        Path folder = Files.createTempDirectory("nephele-save-kills");
        List<String> failures = new ArrayList<>();
        long within = 0;
        Process next = start(file(folder, from));
        try {
            for (long unit = from; unit < from + count; unit++) {
                Process child = next;
                next = unit + 1 < from + count ? start(file(folder, unit + 1)) : null;
                kill(child, new SplittableRandom(unit));
                Path file = file(folder, unit);
                within += Files.exists(beside(file, ".tmp")) || Files.exists(beside(file, ".bak.tmp")) ? 1 : 0;
                judge(unit, file, failures);
                progress.unitsDone(unit - from + 1);
            }
        } finally {
            if (next != null) {
                next.destroyForcibly().waitFor();
            }
            delete(folder);
        }
        return new ProofResult(
                count, failures.size(), List.of(Figure.sum("killed within a save", within, "kills")), failures);
    }

    private static Path file(Path folder, long unit) {
        return folder.resolve("level-" + unit + ".json");
    }

    private static Path beside(Path file, String suffix) {
        return file.resolveSibling(file.getFileName() + suffix);
    }

    /** The cheapest start of a Java process that still does exactly what the editor does when it saves. */
    private static Process start(Path file) throws IOException {
        LevelFile.save(file, SavingChild.level(0));
        Path java = Path.of(System.getProperty("java.home"), "bin", "java");
        return new ProcessBuilder(
                        java.toString(),
                        "-XX:+UseSerialGC",
                        "-XX:TieredStopAtLevel=1",
                        "-Xshare:auto",
                        "-Xmx128m",
                        "-cp",
                        System.getProperty("java.class.path"),
                        SavingChild.class.getName(),
                        file.toString())
                .redirectError(ProcessBuilder.Redirect.DISCARD)
                .start();
    }

    private static void kill(Process child, SplittableRandom random) throws IOException, InterruptedException {
        for (int saves = 1 + random.nextInt(MOST_SAVES_BEFORE); saves > 0; saves--) {
            if (child.getInputStream().read() < 0) {
                throw new IOException("the saving process ended by itself with code " + child.waitFor());
            }
        }
        LockSupport.parkNanos(random.nextLong(LONGEST_WAIT_NANOS));
        child.destroyForcibly().waitFor();
    }

    /** The file itself, not its backup, must be one of the levels that were saved, whole. */
    private static void judge(long unit, Path file, List<String> failures) {
        try {
            Level found = LevelFile.read(file);
            if (!found.equals(SavingChild.level(Integer.parseInt(found.name())))) {
                failures.add("kill " + unit + ": the file holds a level that was never saved");
            }
        } catch (LevelFormatException | NumberFormatException unreadable) {
            failures.add("kill " + unit + ": " + unreadable.getMessage());
        }
    }

    private static void delete(Path folder) throws IOException {
        try (var files = Files.list(folder)) {
            for (Path file : files.toList()) {
                Files.delete(file);
            }
        }
        Files.delete(folder);
    }
}
