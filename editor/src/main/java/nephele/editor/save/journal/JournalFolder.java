package nephele.editor.save.journal;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.time.ZoneOffset;
import java.time.format.DateTimeFormatter;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.ConcurrentHashMap;
import nephele.editor.save.DocumentFile;
import nephele.engine.asset.AtomicFile;
import nephele.engine.level.Level;

/**
 * The folder of all journals of a user. It opens one for each document, and finds those of editors that have ended
 * without saving. A process has one object of this class, because it must not look for locks that it holds itself.
 */
public final class JournalFolder {
    private static final int LONGEST_LOG_BYTES = 256 << 20;
    private static final int LONGEST_LEVEL_BYTES = 16 << 20;
    private static final Duration LITTER_AGE = Duration.ofDays(1);
    private static final DateTimeFormatter ID =
            DateTimeFormatter.ofPattern("uuuuMMdd-HHmmss", Locale.ROOT).withZone(ZoneOffset.UTC);

    private final Path folder;
    private final InstantSource clock;
    private final Set<Path> own = ConcurrentHashMap.newKeySet();

    /**
     * The journals of editors that have ended.
     *
     * @param works the newest first
     * @param unreadable folders of journals that are too damaged; they are left as they are
     */
    public record Findings(List<RecoverableWork> works, List<Path> unreadable) {}

    public JournalFolder(Path folder, InstantSource clock) {
        this.folder = folder;
        this.clock = clock;
    }

    /**
     * Opens the journal of a document that has just been opened.
     *
     * @param title of the document in the list of recoverable work
     */
    public Journal open(DocumentFile file, String title, Level start, JournalListener listener) {
        Instant now = Instant.ofEpochMilli(clock.millis());
        Path place = folder.resolve(
                ID.format(now) + "-" + UUID.randomUUID().toString().substring(0, 8));
        own.add(place);
        var origin = new JournalLog.Origin(title, file, start, now);
        return new Journal(place, new StoredJournal(place), origin, listener, clock, () -> own.remove(place));
    }

    /** Opens a journal that starts with recovered work, and deletes the old one as soon as the new one is on disk. */
    public Journal resume(RecoverableWork work, JournalListener listener) {
        Journal journal = open(work.file(), work.title(), work.saved(), listener);
        journal.record(new JournalLog.Unsaved(work.lastLabel(), work.level(), work.lastEdit(), work.edits()));
        if (journal.flush()) {
            discard(work);
        }
        return journal;
    }

    /** Returns the unsaved work of editors that have ended, and tidies up what holds none. */
    public Findings find() {
        List<RecoverableWork> works = new ArrayList<>();
        List<Path> unreadable = new ArrayList<>();
        for (Path journal : others()) {
            try {
                examine(journal).ifPresent(works::add);
            } catch (IOException damaged) {
                unreadable.add(journal);
            }
        }
        works.sort(Comparator.comparing(RecoverableWork::lastEdit).reversed());
        return new Findings(List.copyOf(works), List.copyOf(unreadable));
    }

    /** Deletes work that its user does not want, unless another process has taken it up. */
    public void discard(RecoverableWork work) {
        try {
            if (!own.contains(work.journal()) && Files.isDirectory(work.journal())) {
                StoredJournal.orphan(work.journal()).ifPresent(StoredJournal::delete);
            }
        } catch (IOException stays) {
            // It is offered again at the next start.
            return;
        }
    }

    private List<Path> others() {
        if (!Files.isDirectory(folder)) {
            return List.of();
        }
        try (var all = Files.list(folder)) {
            return all.filter(each -> Files.isDirectory(each) && !own.contains(each))
                    .sorted()
                    .toList();
        } catch (IOException unreadable) {
            return List.of();
        }
    }

    /** @throws IOException if the journal holds something that cannot be read */
    private Optional<RecoverableWork> examine(Path place) throws IOException {
        Path log = new StoredJournal(place).log();
        if (!Files.exists(log) && !isOld(place)) {
            // Perhaps an editor is about to write its first edit.
            return Optional.empty();
        }
        Optional<StoredJournal> journal = StoredJournal.orphan(place);
        if (journal.isEmpty()) {
            return Optional.empty();
        }
        boolean isEmpty = !Files.exists(log);
        try {
            Optional<RecoverableWork> work = isEmpty ? Optional.empty() : work(journal.get(), log);
            isEmpty |= work.isEmpty();
            return work;
        } finally {
            if (isEmpty) {
                journal.get().delete();
            } else {
                journal.get().release();
            }
        }
    }

    private static Optional<RecoverableWork> work(StoredJournal journal, Path log) throws IOException {
        byte[] bytes = AtomicFile.read(log, LONGEST_LOG_BYTES);
        Optional<Path> picture = Optional.of(journal.picture()).filter(Files::isRegularFile);
        RecoverableWork work = JournalLog.work(journal, bytes, picture)
                .orElseThrow(() -> new IOException("its first record is damaged"));
        return work.edits() == 0 || work.level().equals(work.saved()) || isOnDisk(work)
                ? Optional.empty()
                : Optional.of(work);
    }

    /** Returns true if the editor was killed after a save, before it could note that. */
    private static boolean isOnDisk(RecoverableWork work) {
        Optional<Path> file = work.file().path().filter(Files::isRegularFile);
        try {
            return file.isPresent() && JournalLog.isSaved(work, AtomicFile.read(file.get(), LONGEST_LEVEL_BYTES));
        } catch (IOException unreadable) {
            return false;
        }
    }

    private boolean isOld(Path place) throws IOException {
        Instant touched = Files.getLastModifiedTime(place).toInstant();
        return touched.plus(LITTER_AGE).isBefore(Instant.ofEpochMilli(clock.millis()));
    }
}
