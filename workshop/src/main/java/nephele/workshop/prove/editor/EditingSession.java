package nephele.workshop.prove.editor;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.locks.LockSupport;
import nephele.editor.save.DocumentFile;
import nephele.editor.save.journal.Journal;
import nephele.editor.save.journal.JournalFolder;
import nephele.editor.save.journal.JournalListener;
import nephele.editor.text.Words;
import nephele.engine.level.Environment;
import nephele.engine.level.Level;
import nephele.engine.level.Solid;
import nephele.engine.level.TextureMapping;
import nephele.engine.level.json.LevelJson;
import nephele.engine.math.Vec3;

/**
 * A process that edits an untitled level until it is killed, an edit a frame as in a drag. It prints a line {@code made
 * N} when edit N is made and {@code synced N} when the journal says that it is on disk.
 */
final class EditingSession {
    private static final int SOLIDS = 400;
    private static final long FRAME_NANOS = 16_000_000;

    /** The process ends by itself then, in case its parent has ended without killing it. */
    private static final int MOST_EDITS = 5_000;

    static final String MADE = "made ";
    static final String SYNCED = "synced ";

    private EditingSession() {}

    /** @param arguments the folder of the journals */
    public static void main(String[] arguments) {
        var folder = new JournalFolder(Path.of(arguments[0]), InstantSource.system());
        Level level = start();
        Journal journal = folder.open(DocumentFile.UNTITLED, "session", level, new Printed());
        for (int edit = 1; edit <= MOST_EDITS && !System.out.checkError(); edit++) {
            level = edited(level, edit);
            journal.record("edit " + edit, level);
            System.out.println(MADE + edit);
            LockSupport.parkNanos(FRAME_NANOS);
        }
    }

    /** Returns the level before the first edit. */
    static Level start() {
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
    static Level edited(Level before, int edit) {
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

    /** Prints which edits are on disk. */
    private record Printed() implements JournalListener {
        @Override
        public void recorded(long number) {
            System.out.println(SYNCED + number);
        }

        @Override
        public void failed(Words message) {
            System.out.println("failed " + message);
        }
    }
}
