package nephele.workshop.prove.editor;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.locks.LockSupport;
import nephele.editor.action.ScriptRunner;
import nephele.editor.save.DocumentFile;
import nephele.editor.window.viewport.ViewportSurface;
import nephele.workshop.prove.process.TemporaryFolder;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/**
 * Opens the levels that take longest to draw in the real editor and edits what their tables follow from, while another
 * thread measures how long the event dispatch thread takes to answer. Readers, tables and pictures throw on that thread,
 * which fails the proof as well.
 */
public final class EditorStallsProof implements Proof {
    /**
     * Greatest CPU time of the event dispatch thread between two answers, s. It is not wall-clock time, which grows with
     * the load of the machine.
     */
    static final double MOST_CPU_SECONDS = 0.5;

    private static final Dimension SIZE = new Dimension(960, 640);

    /** A level and the edits that are made one after another, each of them drawn. */
    private record Edited(String level, List<String> edits) {
        private static Edited of(String level, String... edits) {
            return new Edited(level, List.of(edits));
        }
    }

    private static final List<Edited> LEVELS = List.of(
            Edited.of(
                    "samples/clouds-ellipsoid.json",
                    "select ids=environment.clouds/lens",
                    "set value=extinctionPerMetre to=0.02"),
            Edited.of(
                    "samples/weather-scattered.json",
                    "select ids=environment.sky",
                    "set value=timeOfDayHours to=9",
                    "set value=mieScale to=2",
                    "select ids=environment",
                    "set value=weather to=overcast"),
            Edited.of(
                    "samples/clouds-storm.json",
                    "select ids=environment.clouds/tower",
                    "set value=extinctionPerMetre to=0.02",
                    "undo"),
            Edited.of(
                    "06-standing-stones.json",
                    "select ids=environment",
                    "set value=weather to=broken",
                    "terrain-stroke effect=raise from=0,0,0 to=8,0,0"),
            Edited.of(
                    "05-above-the-clouds.json",
                    "select ids=environment.clouds/sea",
                    "set value=extinctionPerMetre to=0.03"),
            Edited.of("samples/terrain.json", "terrain-stroke effect=raise from=0,0,0 to=20,0,0", "tool-terrain"),
            Edited.of("samples/sky-skybox-cross.json", "tool-portal"),
            Edited.of("samples/models.json", "tool-portal"));

    @Override
    public Claim claim() {
        return new Claim(
                "editor-stalls",
                "While the levels that take longest to draw are opened and edited in the editor (clouds, weather, hour,"
                        + " air, terrain), the thread of its window reads no file, computes no table and draws no"
                        + " picture, and no answer to the user costs it half a second of its own time.",
                "levels",
                LEVELS.size(),
                1);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) throws Exception {
        List<String> failures = new ArrayList<>();
        double longest = 0;
        double dearest = 0;
        double drawing = 0;
        Path folder = Files.createTempDirectory("nephele-editor-stalls");
        try (WatchedEvents events = new WatchedEvents()) {
            for (long unit = from; unit < from + count; unit++) {
                var trial = new Trial(events, folder, LEVELS.get((int) unit));
                trial.run().ifPresent(why -> {
                    failures.add(why);
                    progress.failed(why);
                });
                longest = Math.max(longest, trial.answers.longestSeconds());
                dearest = Math.max(dearest, trial.answers.dearestSeconds());
                drawing = Math.max(drawing, trial.longestPictureSeconds);
                progress.unitsDone(unit + 1 - from);
            }
        } finally {
            TemporaryFolder.delete(folder);
        }
        return ProofResult.of(
                count,
                failures,
                Figure.greatest("longest answer", longest, "s"),
                Figure.greatest("of its thread's time", dearest, "s"),
                Figure.greatest("longest picture meanwhile", drawing, "s"));
    }

    /** One level in an editor of its own. */
    private static final class Trial {
        private final WatchedEvents events;
        private final Path folder;
        private final Edited edited;
        private final BufferedImage screen = new BufferedImage(SIZE.width, SIZE.height, BufferedImage.TYPE_INT_RGB);
        private final AnswerWatch answers = new AnswerWatch();
        private StageDesk ui;
        private EditorUnderEvents editor;
        private ScriptRunner script;
        private CompletableFuture<?> drawing;
        private double longestPictureSeconds;

        Trial(WatchedEvents events, Path folder, Edited edited) {
            this.events = events;
            this.folder = folder;
            this.edited = edited;
        }

        /** Returns what went wrong first. */
        Optional<String> run() throws Exception {
            Path level = copied();
            DocumentFile.Opened empty =
                    DocumentFile.open(Path.of("levels", "samples", "empty.json").toString());
            Optional<String> failure = events.run(() -> begin(empty, level));
            failure = failure.isPresent() ? failure : drawn();
            answers.begin();
            try {
                failure = failure.isPresent() ? failure : step("open");
                for (int i = 0; i < edited.edits.size() && failure.isEmpty(); i++) {
                    failure = step(edited.edits.get(i));
                }
            } finally {
                answers.end();
            }
            Optional<String> end = events.run(() -> editor.close());
            failure = failure.or(() -> end).or(this::tooDear);
            return failure.map(why -> edited.level + ": " + why);
        }

        /** Strokes write a file beside their level. */
        private Path copied() throws Exception {
            Path source = Path.of("levels").resolve(edited.level);
            return Files.copy(source, folder.resolve(source.getFileName()));
        }

        private void begin(DocumentFile.Opened empty, Path level) {
            var dialogues = new DialogStage(new SplittableRandom(1));
            ui = new StageDesk(dialogues, () -> Optional.of(level));
            editor = new EditorUnderEvents(empty, folder, ui, dialogues);
            editor.resize(SIZE);
            script = new ScriptRunner(editor.session(), ui);
        }

        private Optional<String> step(String line) throws Exception {
            Optional<String> failure = events.run(() -> script.run(line)).map(why -> line + ": " + why);
            return failure.isPresent() ? failure : drawn().map(why -> "after " + line + ": " + why);
        }

        /** Paints the window until its viewport shows the present level. */
        private Optional<String> drawn() throws Exception {
            long start = System.nanoTime();
            boolean isDrawn = false;
            while (!isDrawn) {
                Optional<String> failure = events.run(this::paint);
                if (failure.isPresent()) {
                    return failure;
                }
                isDrawn = drawing.isDone();
                drawing.join();
            }
            longestPictureSeconds = Math.max(longestPictureSeconds, (System.nanoTime() - start) * 1e-9);
            return Optional.empty();
        }

        private void paint() {
            ViewportSurface surface = editor.panel().viewport().surface();
            Component picture = surface.component();
            Graphics2D graphics = screen.createGraphics();
            try {
                editor.panel().paint(graphics);
                picture.paint(graphics);
            } finally {
                graphics.dispose();
            }
            surface.failure().ifPresent(failure -> {
                throw new IllegalStateException("the viewport cannot be drawn: " + failure, failure);
            });
            drawing = surface.drawing();
        }

        private Optional<String> tooDear() {
            return answers.dearestSeconds() < MOST_CPU_SECONDS
                    ? Optional.empty()
                    : Optional.of("an answer cost " + answers.dearestSeconds() + " s of the window's thread");
        }
    }

    /** Asks Swing's thread for an answer again and again, and keeps how long the slowest one was awaited. */
    private static final class AnswerWatch {
        private static final long BETWEEN_NANOS = 5_000_000;

        private final ThreadMXBean threads = ManagementFactory.getThreadMXBean();
        private final Thread asking = new Thread(this::ask, "answers");
        private volatile boolean isOver;
        private long dispatcher;
        private long longestNanos;
        private long dearestNanos;

        void begin() {
            asking.setDaemon(true);
            asking.start();
        }

        private void ask() {
            try {
                long before = answered();
                while (!isOver) {
                    long start = System.nanoTime();
                    long after = answered();
                    longestNanos = Math.max(longestNanos, System.nanoTime() - start);
                    dearestNanos = Math.max(dearestNanos, after - before);
                    before = after;
                    LockSupport.parkNanos(BETWEEN_NANOS);
                }
            } catch (InterruptedException interrupted) {
                Thread.currentThread().interrupt();
            }
        }

        /** Waits for an answer; returns the time that the thread has worked since it began. */
        private long answered() throws InterruptedException {
            var answer = new CountDownLatch(1);
            EventQueue.invokeLater(() -> {
                dispatcher = Thread.currentThread().getId();
                answer.countDown();
            });
            answer.await();
            return threads.getThreadCpuTime(dispatcher);
        }

        void end() throws InterruptedException {
            isOver = true;
            asking.join();
        }

        /** Returns the longest time for which an answer was awaited, after the {@link #end}. */
        double longestSeconds() {
            return longestNanos * 1e-9;
        }

        /** Returns the most time that the thread itself has worked between two answers. */
        double dearestSeconds() {
            return dearestNanos * 1e-9;
        }
    }
}
