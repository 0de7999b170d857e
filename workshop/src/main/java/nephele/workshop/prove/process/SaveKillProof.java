package nephele.workshop.prove.process;

import com.google.gson.JsonObject;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.locks.LockSupport;
import nephele.engine.level.Level;
import nephele.engine.level.json.LevelFile;
import nephele.engine.level.json.LevelFormatException;
import nephele.engine.level.json.LevelJson;
import nephele.host.userfile.UserFile;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/**
 * Kills processes that save files of one kind in generations, each with a content of its own size, at random moments, and
 * reads the files that remain. A unit is a kill within a save; a kill between two saves is repeated.
 */
public enum SaveKillProof implements Proof {
    /** Saves levels as the editor does. */
    LEVELS("save-kills", "Killing the process at any moment of a save leaves a complete old or new level file.") {
        @Override
        void save(Path file, int generation) {
            LevelFile.save(file, level(generation));
        }

        @Override
        String problem(Path file) {
            try {
                Level found = LevelFile.read(file);
                return found.equals(level(Integer.parseInt(found.name())))
                        ? null
                        : "the file holds a level that was never saved";
            } catch (LevelFormatException | NumberFormatException unreadable) {
                return unreadable.getMessage();
            }
        }
    },
    /** Saves settings as the game does. */
    SETTINGS(
            "settings-kills",
            "Killing the process at any moment of a save leaves complete old or new settings, unknown entries"
                    + " included.") {
        @Override
        void save(Path file, int generation) throws IOException {
            new UserFile(file, "nephele-settings", 1).save(entries(generation));
        }

        @Override
        String problem(Path file) {
            List<String> problems = new ArrayList<>();
            JsonObject found = new UserFile(file, "nephele-settings", 1).read(problems::add);
            if (!problems.isEmpty()) {
                return problems.toString();
            }
            return found.has("generation")
                            && found.equals(entries(found.get("generation").getAsInt()))
                    ? null
                    : "the file holds entries that were never saved";
        }
    };

    private static final int MOST_SAVES_BEFORE = 3;

    /** The latest moment of a kill, in durations of the previous save, because some saves take longer. */
    private static final double LENGTHS = 1.25;

    /** A limit at which a saving process ends by itself, in case its parent has ended without killing it. */
    private static final int MOST_SAVES = 5_000;

    /** Written when a save begins; {@link #ENDED} when it has ended. */
    static final char BEGUN = '(';

    static final char ENDED = ')';

    private final String proof;
    private final String sentence;

    SaveKillProof(String proof, String sentence) {
        this.proof = proof;
        this.sentence = sentence;
    }

    @Override
    public Claim claim() {
        return new Claim(proof, sentence, "kills within a save", 1_000, 100);
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
        return reported.endsWith(String.valueOf(BEGUN));
    }

    private static boolean isUnfinished(Path file) throws IOException {
        try (var left = Files.list(file.getParent())) {
            return left.anyMatch(each -> each.toString().endsWith(".tmp"));
        }
    }

    private static Path file(Path folder, long unit) {
        return folder.resolve("saved-" + unit + ".json");
    }

    /** Starts a process that saves exactly as the program does. */
    private KillableProcess start(Path file) throws IOException {
        save(file, 0);
        return KillableProcess.start(SaveKillProof.class, name(), file.toString());
    }

    /** Waits for a few saves and kills the process within about the duration of one after the next has begun. */
    private static String kill(KillableProcess child, SplittableRandom random)
            throws IOException, InterruptedException {
        var reported = new StringBuilder();
        long begun = 0;
        long nanos = 0;
        for (int saves = 1 + random.nextInt(MOST_SAVES_BEFORE); saves >= 0; saves--) {
            awaitNext(child, BEGUN, reported);
            begun = System.nanoTime();
            if (saves > 0) {
                awaitNext(child, ENDED, reported);
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
        String problem = problem(file);
        if (problem != null) {
            failures.add("kill " + unit + ": " + problem);
        }
    }

    /** Saves the content of a generation. */
    abstract void save(Path file, int generation) throws IOException;

    /** Returns why the file, not its backup, is no complete generation; {@code null} if it is one. */
    abstract String problem(Path file);

    private static JsonObject entries(int generation) {
        JsonObject entries = new JsonObject();
        entries.addProperty("generation", generation);
        for (int i = 0; i < generation * 37 % 200; i++) {
            entries.addProperty("unknown entry " + i, "kept " + generation);
        }
        return entries;
    }

    private static Level level(int generation) {
        StringBuilder json = new StringBuilder("{\"format\": \"nephele-level\", \"version\": 1, \"name\": \"");
        json.append(generation).append("\", \"solids\": [");
        for (int i = 0; i < generation * 37 % 200; i++) {
            json.append(i == 0 ? "" : ",")
                    .append("{\"id\": \"s")
                    .append(i)
                    .append("\", \"kind\": \"box\", \"centre\": [")
                    .append(i)
                    .append(", 0.5, ")
                    .append(generation)
                    .append("], \"size\": [1, 1, 1]}");
        }
        return LevelJson.read("generated", json.append("]}").toString().getBytes(StandardCharsets.UTF_8));
    }

    /**
     * Saves one generation after another until the process is killed, and writes when each save begins and ends.
     *
     * @param arguments the constant's name and the file
     */
    public static void main(String[] arguments) throws IOException {
        SaveKillProof kind = SaveKillProof.valueOf(arguments[0]);
        Path file = Path.of(arguments[1]);
        for (int generation = 1; generation <= MOST_SAVES; generation++) {
            report(BEGUN);
            kind.save(file, generation);
            report(ENDED);
            if (System.out.checkError()) {
                return;
            }
        }
    }

    private static void report(char what) {
        System.out.write(what);
        System.out.flush();
    }
}
