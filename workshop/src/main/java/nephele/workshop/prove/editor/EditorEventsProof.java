package nephele.workshop.prove.editor;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import nephele.editor.save.DocumentFile;
import nephele.engine.render.gl.GlKind;
import nephele.workshop.prove.process.TemporaryFolder;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/**
 * Sends random input to the real editor. Each session has a fresh editor and {@value #EVENTS_OF_SESSION} events, seeded
 * by its number; a range of units that begins within a session is counted from its first event.
 */
public final class EditorEventsProof implements Proof {
    private static final int EVENTS_OF_SESSION = 1000;
    private static final int EVENTS_A_PICTURE = 4;
    private static final int EVENTS_A_CHECK = 50;

    @Override
    public Claim claim() {
        return new Claim(
                "editor-events",
                "No random input to the editor (mouse, wheel, keys, commands, panels, dialogues,"
                        + " sizes, settings, other levels, saving, dropped files, repairs of problems)"
                        + " throws, blocks for a minute, or leaves OpenGL objects; the level can always be written"
                        + " and is equal when read back.",
                "events",
                100_000,
                EVENTS_OF_SESSION);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) throws Exception {
        List<String> failures = new ArrayList<>();
        long drawn = 0;
        try (LevelCopies levels = LevelCopies.make();
                WatchedEvents events = new WatchedEvents()) {
            for (long done = 0; done < count; ) {
                int length = (int) Math.min(EVENTS_OF_SESSION, count - done);
                Session session = new Session(events, levels, (from + done) / EVENTS_OF_SESSION);
                Optional<String> failure = session.run(length);
                failure.ifPresent(failures::add);
                failure.ifPresent(progress::failed);
                drawn += session.pictures;
                done += length;
                progress.unitsDone(done);
                if (session.isBlocked) {
                    break;
                }
            }
        }
        return ProofResult.of(count, failures, Figure.sum("pictures drawn", drawn, ""));
    }

    /** One editor and its events. */
    private static final class Session {
        private final WatchedEvents thread;
        private final LevelCopies levels;
        private final long number;
        private final SplittableRandom random;
        private EditorUnderEvents editor;
        private RandomEvents events;
        private Map<GlKind, Integer> objects;
        private long pictures;
        private boolean isBlocked;

        Session(WatchedEvents thread, LevelCopies levels, long number) {
            this.thread = thread;
            this.levels = levels;
            this.number = number;
            random = new SplittableRandom(number);
        }

        /** Returns the first failure. */
        Optional<String> run(int length) throws Exception {
            DocumentFile.Opened base = DocumentFile.open(levels.base().toString());
            Optional<String> failure = thread.run(() -> open(base)).map(why -> reported(0, "opening", why));
            for (int event = 1; event <= length && failure.isEmpty(); event++) {
                int now = event;
                failure = thread.run(() -> event(now)).map(why -> reported(now, events.last(), why));
            }
            isBlocked = failure.isPresent() && failure.get().contains("no answer");
            if (editor != null && !isBlocked) {
                Optional<String> end = thread.run(failure.isEmpty() ? this::end : editor::close)
                        .map(why -> reported(length, "end", why));
                failure = failure.or(() -> end);
            }
            return failure;
        }

        private String reported(int event, String what, String why) {
            return "session " + number + ", event " + event + " (" + what + "): " + why;
        }

        private void open(DocumentFile.Opened base) {
            DialogStage dialogues = new DialogStage(random);
            StageDesk ui = new StageDesk(dialogues, () -> Optional.of(levels.any(random)));
            editor = new EditorUnderEvents(base, levels.folder(), ui, dialogues);
            events = new RandomEvents(editor, random, () -> levels.anyToDrop(random));
            objects = editor.liveObjects();
            // The level of the beginning is not edited: saving would change what the end is compared with.
            editor.panel().commands().named("open").orElseThrow().run();
        }

        private void event(int number) throws Exception {
            events.send();
            if (number % EVENTS_A_PICTURE == 0) {
                editor.paint();
                pictures++;
            }
            if (number % EVENTS_A_CHECK == 0) {
                editor.requireWritable();
            }
        }

        private void end() throws Exception {
            editor.requireWritable();
            Map<GlKind, Integer> left = editor.liveObjects();
            editor.close();
            if (!left.equals(objects)) {
                throw new IllegalStateException("OpenGL objects " + left + " instead of " + objects);
            }
        }
    }

    /** Copies of the level files, so that nothing can change those of the checkout. */
    private record LevelCopies(Path folder, Path base, List<Path> files) implements AutoCloseable {
        private static final List<String> NAMES = List.of(
                "samples/empty.json",
                "01-courtyard.json",
                "02-first-shot.json",
                "04-cube.json",
                "samples/cameras.json",
                "samples/lamps.json",
                "samples/facing-portals.json",
                "samples/solid-prism.json",
                "samples/solid-planes.json",
                "samples/texture-placement.json",
                "samples/slanted-walls.json",
                "samples/sky-gradient.json");

        private static final List<String> DROPPED = List.of(
                "assets/textures/metal-frame.png",
                "assets/models/vase.obj",
                "assets/models/knot.gltf",
                "scenes/invalid/torn.3d",
                "scenes/invalid/flat-scale.xml",
                "levels/no-such-file.json",
                "README.md");

        static LevelCopies make() throws IOException {
            Path folder = Files.createTempDirectory("nephele-editor-events");
            List<Path> files = new ArrayList<>();
            for (String name : NAMES) {
                Path copy = folder.resolve(name);
                Files.createDirectories(copy.getParent());
                files.add(Files.copy(Path.of("levels").resolve(name), copy));
            }
            Path base = Files.copy(Path.of("levels").resolve(NAMES.get(0)), folder.resolve("base.json"));
            return new LevelCopies(folder, base, List.copyOf(files));
        }

        Path anyToDrop(SplittableRandom random) {
            return Path.of(DROPPED.get(random.nextInt(DROPPED.size())));
        }

        Path any(SplittableRandom random) {
            return files.get(random.nextInt(files.size()));
        }

        @Override
        public void close() throws IOException {
            TemporaryFolder.delete(folder);
        }
    }
}
