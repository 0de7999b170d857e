package nephele.editor.save.journal;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Instant;
import java.time.InstantSource;
import java.util.concurrent.TimeUnit;
import nephele.editor.save.DocumentFile;
import nephele.editor.save.SaveText;
import nephele.engine.asset.AtomicFile;
import nephele.engine.level.Level;

/**
 * The record on disk of a document's unsaved edits. Methods that take an edit return at once; one thread writes the
 * latest state, at most a few times a second, and syncs it within two seconds of the edit. States in between are not
 * written: a drag costs its end. Nothing is written before the first edit.
 */
public final class Journal implements AutoCloseable {
    private static final long PAUSE_NANOS = TimeUnit.MILLISECONDS.toNanos(250);
    private static final long RETRY_NANOS = TimeUnit.SECONDS.toNanos(1);

    private final Path folder;
    private final JournalStore store;
    private final JournalLog log;
    private final JournalListener listener;
    private final InstantSource clock;
    private final Runnable onEnd;
    private final Thread writer;

    // All below are guarded by this; files are never touched while it is held.
    private JournalLog.Origin origin;
    private JournalLog.Unsaved latest;
    private Pending pending = Pending.NOTHING;
    private long earliestNanos = System.nanoTime();
    private long failures;
    private int hurries;
    private boolean isWriting;
    private boolean isEnding;

    /**
     * What has to be written.
     *
     * @param origin from which the state was edited
     */
    private record Pending(JournalLog.Origin origin, boolean isSaved, JournalLog.Unsaved state, byte[] picture) {
        static final Pending NOTHING = new Pending(null, false, null, null);

        /** Returns this work, which failed, with what has been asked since. */
        Pending before(Pending later) {
            return later.isSaved
                    ? later
                    : new Pending(
                            origin,
                            isSaved,
                            later.state == null ? state : later.state,
                            later.picture == null ? picture : later.picture);
        }
    }

    /** @param onEnd runs when the journal is closed */
    Journal(
            Path folder,
            JournalStore store,
            JournalLog.Origin origin,
            JournalListener listener,
            InstantSource clock,
            Runnable onEnd) {
        this.folder = folder;
        this.store = store;
        this.origin = origin;
        this.listener = listener;
        this.clock = clock;
        this.onEnd = onEnd;
        log = new JournalLog(store);
        writer = new Thread(this::writeAll, "nephele-journal");
        writer.setDaemon(true);
        writer.start();
    }

    /**
     * Records the state after an edit, an undo or a redo.
     *
     * @param label of the edit, as the history shows it
     */
    public synchronized void record(String label, Level level) {
        long number = latest == null ? 1 : latest.number() + 1;
        record(new JournalLog.Unsaved(label, level, now(), number));
    }

    synchronized void record(JournalLog.Unsaved state) {
        latest = state;
        pending = new Pending(origin, pending.isSaved, state, pending.picture);
        notifyAll();
    }

    /** Records that a level of this document was saved; edits made after it stay unsaved. */
    public synchronized void saved(DocumentFile file, Level level) {
        boolean isNewest = latest == null || latest.level() == level;
        latest = isNewest ? null : new JournalLog.Unsaved(latest.label(), latest.level(), latest.time(), 1);
        String title = file.path().map(path -> path.getFileName().toString()).orElse(origin.title());
        origin = new JournalLog.Origin(title, file, level, now());
        pending = new Pending(origin, true, latest, null);
        notifyAll();
    }

    /** Records a small picture of the document for the list of recoverable work; one before the first edit is dropped. */
    public synchronized void picture(byte[] png) {
        if (latest != null) {
            pending = new Pending(origin, pending.isSaved, pending.state, png.clone());
            notifyAll();
        }
    }

    /** Writes everything at once and waits for it; returns false if that failed. A write that is under way may fail. */
    public synchronized boolean flush() {
        long mostFailures = failures + (isWriting ? 1 : 0);
        hurries++;
        notifyAll();
        boolean isInterrupted = false;
        while ((pending != Pending.NOTHING || isWriting) && failures <= mostFailures && !isEnding) {
            try {
                wait();
            } catch (InterruptedException later) {
                isInterrupted = true;
            }
        }
        hurries--;
        if (isInterrupted) {
            Thread.currentThread().interrupt();
        }
        return pending == Pending.NOTHING && !isWriting;
    }

    /** Ends the journal. Unsaved work stays on disk and is offered at the next start; without any, nothing stays. */
    @Override
    public void close() {
        flush();
        if (end()) {
            store.release();
        } else {
            store.delete();
        }
        onEnd.run();
    }

    /** Ends the journal and deletes it, because its user does not want what is unsaved. */
    public void discard() {
        end();
        store.delete();
        onEnd.run();
    }

    /** Ends the thread; returns true if something is unsaved. */
    private boolean end() {
        boolean isUnsaved;
        synchronized (this) {
            isEnding = true;
            isUnsaved = latest != null && !latest.level().equals(origin.level());
            notifyAll();
        }
        try {
            writer.join();
        } catch (InterruptedException hurry) {
            Thread.currentThread().interrupt();
        }
        return isUnsaved;
    }

    private Instant now() {
        return Instant.ofEpochMilli(clock.millis());
    }

    private void writeAll() {
        boolean reported = false;
        for (Pending work = next(); work != null; work = next()) {
            String problem = attempt(work);
            if (problem != null && !reported) {
                listener.failed(SaveText.NOT_RECORDED.with(folder, problem));
            } else if (problem == null && work.state != null) {
                listener.recorded(work.state.number());
            }
            reported = problem != null;
            finish(work, problem);
        }
    }

    /** Waits for work that is due; {@code null} at the end. */
    private synchronized Pending next() {
        try {
            while (!isEnding) {
                long nanos = earliestNanos - System.nanoTime();
                if (pending == Pending.NOTHING) {
                    wait();
                } else if (nanos > 0 && hurries == 0) {
                    TimeUnit.NANOSECONDS.timedWait(this, nanos);
                } else {
                    Pending work = pending;
                    pending = Pending.NOTHING;
                    isWriting = true;
                    return work;
                }
            }
        } catch (InterruptedException stop) {
            return null;
        }
        return null;
    }

    /** Returns why the work failed; {@code null} if it is on disk. */
    private String attempt(Pending work) {
        try {
            if (work.isSaved) {
                log.saved();
            }
            if (work.state != null) {
                log.write(work.origin, work.state);
            }
            if (work.picture != null) {
                log.picture(work.picture);
            }
            return null;
        } catch (IOException problem) {
            return AtomicFile.reason(problem);
        } catch (RuntimeException | Error unwritable) {
            return String.valueOf(unwritable.getMessage()).lines().findFirst().orElse("");
        }
    }

    private synchronized void finish(Pending work, String problem) {
        isWriting = false;
        earliestNanos = System.nanoTime() + (problem == null ? PAUSE_NANOS : RETRY_NANOS);
        if (problem != null) {
            failures++;
            pending = work.before(pending);
        }
        notifyAll();
    }
}
