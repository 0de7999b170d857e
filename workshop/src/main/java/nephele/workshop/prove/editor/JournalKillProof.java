package nephele.workshop.prove.editor;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.TreeMap;
import java.util.concurrent.locks.LockSupport;
import nephele.editor.save.DocumentFile;
import nephele.editor.save.journal.Journal;
import nephele.editor.save.journal.JournalFolder;
import nephele.editor.save.journal.JournalListener;
import nephele.editor.save.journal.RecoverableWork;
import nephele.editor.text.Words;
import nephele.engine.level.Environment;
import nephele.engine.level.Level;
import nephele.engine.level.Solid;
import nephele.engine.level.TextureMapping;
import nephele.engine.level.json.LevelJson;
import nephele.engine.math.Vec3;
import nephele.workshop.prove.process.KillableProcess;
import nephele.workshop.prove.process.TemporaryFolder;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/** Kills editing processes at random moments and recovers their work from the journals that remain. */
public final class JournalKillProof implements Proof {
    private static final String LOST = "work lost at most";
    private static final double ALLOWED_SECONDS = 2;
    private static final int SOLIDS = 400;
    private static final long FRAME_NANOS = 16_000_000;
    /** The process ends by itself then, in case its parent has ended without killing it. */
    private static final int MOST_EDITS = 5_000;

    private static final String MADE = "made ";
    private static final String SYNCED = "synced ";

    private final double longestSeconds;

    /** @param longestSeconds of a session; above two, or the claim about lost work is not put to the test */
    public JournalKillProof(double longestSeconds) {
        this.longestSeconds = longestSeconds;
    }

    @Override
    public Claim claim() {
        return new Claim(
                "journal-kills",
                "An editor killed at any moment loses at most the last 2 s of work, even of a level that was never"
                        + " saved.",
                "kills",
                100,
                25);
    }

    /** The time of each edit and the last edit synced to disk, as the killed process printed them. */
    private static final class Printed {
        private final TreeMap<Long, Long> nanosByEdit = new TreeMap<>();
        private long synced;
        private String failure;

        void line(String line) {
            if (line.startsWith(MADE)) {
                nanosByEdit.put(Long.parseLong(line.substring(MADE.length())), System.nanoTime());
            } else if (line.startsWith(SYNCED)) {
                synced = Long.parseLong(line.substring(SYNCED.length()));
            } else {
                failure = line;
            }
        }

        /** Returns how long before the kill the first lost edit was made. */
        double lostSeconds(long recovered, long killedNanos) {
            var firstLost = nanosByEdit.higherEntry(recovered);
            return firstLost == null ? 0 : Math.max(0, (killedNanos - firstLost.getValue()) / 1e9);
        }
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) throws Exception {
        List<String> failures = new ArrayList<>();
        double mostLost = 0;
        long edits = 0;
        for (long unit = from; unit < from + count; unit++) {
            Path folder = Files.createTempDirectory("nephele-journal-kill");
            try {
                Printed printed = new Printed();
                long killedNanos = session(folder, new SplittableRandom(unit), printed);
                long recovered = recovered(unit, folder, printed, failures);
                mostLost = Math.max(mostLost, printed.lostSeconds(recovered, killedNanos));
                edits += printed.nanosByEdit.size();
            } finally {
                TemporaryFolder.delete(folder);
            }
            progress.unitsDone(unit - from + 1);
        }
        return ProofResult.of(
                count, failures, Figure.greatest(LOST, mostLost, "s"), Figure.sum("edits made", edits, ""));
    }

    @Override
    public ProofResult judged(ProofResult soFar) {
        double lost = soFar.value(LOST);
        if (lost <= ALLOWED_SECONDS) {
            return soFar;
        }
        return soFar.and(ProofResult.of(0, List.of("a kill lost the work of " + lost + " s"), List.of()));
    }

    /** Runs a session and kills it; returns the moment before the kill. */
    private long session(Path folder, SplittableRandom random, Printed printed) throws Exception {
        try (var child = KillableProcess.startWithErrors(JournalKillProof.class, folder.toString());
                var lines = new BufferedReader(new InputStreamReader(child.output(), StandardCharsets.UTF_8))) {
            printed.line(String.valueOf(lines.readLine()));
            long end = System.nanoTime() + (long) (random.nextDouble() * longestSeconds * 1e9);
            while (System.nanoTime() < end && printed.failure == null) {
                printed.line(String.valueOf(lines.readLine()));
            }
            long killed = System.nanoTime();
            child.kill();
            // The kill may have torn the last line, which ends without a line feed.
            String rest = readRest(lines);
            rest.substring(0, rest.lastIndexOf('\n') + 1).lines().forEach(printed::line);
            return killed;
        }
    }

    private static String readRest(BufferedReader lines) throws IOException {
        StringBuilder rest = new StringBuilder();
        for (int c = lines.read(); c >= 0; c = lines.read()) {
            rest.append((char) c);
        }
        return rest.toString();
    }

    /** Returns the number of the edit whose state was recovered; 0 for none. */
    private static long recovered(long unit, Path folder, Printed printed, List<String> failures) {
        var found = new JournalFolder(folder, InstantSource.system()).find();
        if (printed.failure != null) {
            failures.add("kill " + unit + ": the session printed " + printed.failure);
            return 0;
        }
        if (!found.unreadable().isEmpty() || found.works().size() > 1) {
            failures.add("kill " + unit + ": found " + found);
            return 0;
        }
        long edit = found.works().isEmpty() ? 0 : found.works().get(0).edits();
        if (edit < printed.synced) {
            failures.add("kill " + unit + ": edit " + printed.synced + " was on disk, but " + edit + " is recovered");
        } else if (edit > 0 && !isState(found.works().get(0))) {
            failures.add("kill " + unit + ": the recovered level is not the one after edit " + edit);
        }
        return edit;
    }

    private static boolean isState(RecoverableWork work) {
        Level expected = start();
        for (int edit = 1; edit <= work.edits(); edit++) {
            expected = edited(expected, edit);
        }
        return work.level().equals(expected) && work.saved().equals(start());
    }

    /**
     * Edits an untitled level until the process is killed, an edit a frame as in a drag. It prints a line {@code made N}
     * when edit N is made and {@code synced N} when the journal says that it is on disk.
     *
     * @param arguments the folder of the journals
     */
    public static void main(String[] arguments) {
        var folder = new JournalFolder(Path.of(arguments[0]), InstantSource.system());
        Level level = start();
        Journal journal = folder.open(DocumentFile.UNTITLED, "session", level, printing());
        for (int edit = 1; edit <= MOST_EDITS && !System.out.checkError(); edit++) {
            level = edited(level, edit);
            journal.record("edit " + edit, level);
            System.out.println(MADE + edit);
            LockSupport.parkNanos(FRAME_NANOS);
        }
    }

    /** Returns a listener that prints which edits are on disk. */
    private static JournalListener printing() {
        return new JournalListener() {
            @Override
            public void recorded(long number) {
                System.out.println(SYNCED + number);
            }

            @Override
            public void failed(Words message) {
                System.out.println("failed " + message);
            }
        };
    }

    /** Returns the level before the first edit. */
    private static Level start() {
        List<Solid> solids = new ArrayList<>();
        for (int i = 0; i < SOLIDS; i++) {
            solids.add(box(i, 0));
        }
        Environment environment = LevelJson.read(
                        "start", "{\"format\": \"nephele-level\", \"version\": 1}".getBytes(StandardCharsets.UTF_8))
                .environment();
        return Level.of("session", "", environment, List.of()).with(List.of(), solids);
    }

    /** Returns the level after an edit: one solid is moved, or for every seventh edit all are. */
    private static Level edited(Level before, int edit) {
        List<Solid> solids = new ArrayList<>(before.solids());
        if (edit % 7 == 0) {
            for (int i = 0; i < SOLIDS; i++) {
                solids.set(i, box(i, edit));
            }
        } else {
            solids.set(edit * 31 % SOLIDS, box(edit * 31 % SOLIDS, edit));
        }
        return before.with(before.materials(), List.copyOf(solids));
    }

    private static Solid box(int index, int edit) {
        return new Solid.Box(
                "solid-" + index,
                null,
                false,
                TextureMapping.WORLD,
                new Vec3(index * 2, edit * 0.125, 0),
                new Vec3(1, 1, 1),
                Map.of());
    }
}
