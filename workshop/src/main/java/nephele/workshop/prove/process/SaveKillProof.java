package nephele.workshop.prove.process;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.locks.LockSupport;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/**
 * Kills processes that save files of one kind, at random moments, and reads the files that remain. A unit is a kill within a save;
 * a kill between two saves is repeated.
 */
public final class SaveKillProof implements Proof {
    private static final int MOST_SAVES_BEFORE = 3;

    /** The latest moment of a kill, in durations of the previous save, because some saves take longer. */
    private static final double LENGTHS = 1.25;

    /** Saves levels as the editor does. */
    public static final Proof LEVELS = new SaveKillProof(SavedFile.LEVEL);

    /** Saves settings as the game does. */
    public static final Proof SETTINGS = new SaveKillProof(SavedFile.PLAYER);

    private final SavedFile kind;

    private SaveKillProof(SavedFile kind) {
        this.kind = kind;
    }

    @Override
    public Claim claim() {
        return new Claim(kind.proof(), kind.claim(), "kills within a save", 1_000, 100);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) throws Exception {
        Path folder = Files.createTempDirectory("nephele-save-kills");
        List<String> failures = new ArrayList<>();
        var random = new SplittableRandom(from);
        long within = 0;
        long kills = 0;
        long unfinished = 0;
        KillableProcess next = start(file(folder, 0));
        try {
            while (within < count) {
                KillableProcess child = next;
                Path file = file(folder, kills);
                next = start(file(folder, ++kills));
                boolean isWithin = isWithinASave(kill(child, random));
                unfinished += isWithin && isUnfinished(file) ? 1 : 0;
                judge(from + within, file, failures);
                if (isWithin) {
                    progress.unitsDone(++within);
                    random = new SplittableRandom(from + within);
                }
            }
        } finally {
            next.kill();
            TemporaryFolder.delete(folder);
        }
        List<Figure> figures = List.of(
                Figure.sum("kills that left a file half-written or not yet in its place", unfinished, ""),
                Figure.sum("further kills, between two saves", kills - within, ""));
        return ProofResult.of(count, failures, figures);
    }

    /** @param reported everything that a killed process wrote */
    static boolean isWithinASave(String reported) {
        return reported.endsWith(String.valueOf(SavedFile.BEGUN));
    }

    private static boolean isUnfinished(Path file) throws IOException {
        try (var left = Files.list(file.getParent())) {
            return left.anyMatch(each -> each.toString().endsWith(".tmp"));
        }
    }

    private static Path file(Path folder, long unit) {
        return folder.resolve("saved-" + unit + ".json");
    }

    private static Path beside(Path file, String suffix) {
        return file.resolveSibling(file.getFileName() + suffix);
    }

    /** Starts a process that saves exactly as the program does. */
    private KillableProcess start(Path file) throws IOException {
        kind.save(file, 0);
        return KillableProcess.start(KillableProcess.Errors.DISCARDED, SavedFile.class, kind.name(), file.toString());
    }

    /** Waits for a few saves and kills the process within about the duration of one after the next has begun. */
    private static String kill(KillableProcess child, SplittableRandom random)
            throws IOException, InterruptedException {
        var reported = new StringBuilder();
        long begun = 0;
        long nanos = 0;
        for (int saves = 1 + random.nextInt(MOST_SAVES_BEFORE); saves >= 0; saves--) {
            awaitNext(child, SavedFile.BEGUN, reported);
            begun = System.nanoTime();
            if (saves > 0) {
                awaitNext(child, SavedFile.ENDED, reported);
                nanos = System.nanoTime() - begun;
            }
        }
        LockSupport.parkNanos((long) (random.nextDouble() * LENGTHS * nanos));
        child.kill();
        return reported.append(new String(child.output().readAllBytes(), StandardCharsets.US_ASCII))
                .toString();
    }

    private static void awaitNext(KillableProcess child, char expected, StringBuilder reported)
            throws IOException, InterruptedException {
        int next = child.output().read();
        if (next != expected) {
            throw new IOException("the saving process ended by itself with code " + child.waitFor());
        }
        reported.append(expected);
    }

    /** Checks that the file itself, not its backup, is one of the saved generations, complete. */
    private void judge(long unit, Path file, List<String> failures) {
        String problem = kind.problem(file);
        if (problem != null) {
            failures.add("kill " + unit + ": " + problem);
        }
    }
}
