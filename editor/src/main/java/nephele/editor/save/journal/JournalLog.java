package nephele.editor.save.journal;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import nephele.editor.save.DocumentFile;
import nephele.engine.level.Level;
import nephele.engine.level.json.LevelFormatException;
import nephele.engine.level.json.LevelJson;

/**
 * The log of a journal. States of a document are written to it, the first one as base and edit, further ones as
 * differences; it starts anew when it has become long and after every failure, which may have left a torn record. After
 * a crash the last state that can be read is rebuilt from it.
 */
final class JournalLog {
    private static final int LONG_LOG_BYTES = 4 << 20;

    /** The document as it was opened or last saved. */
    record Origin(String title, DocumentFile file, Level level, Instant time) {}

    /** A state that was read: its text, and the edit that made it, {@code null} for the base. */
    private record State(JournalRecord.Edit edit, byte[] text) {}

    /** A state that is not saved. */
    record Unsaved(String label, Level level, Instant time, long number) {}

    private final JournalStore store;
    private JournalRecord.Base base;
    private byte[] written;
    private long appendedBytes;
    private boolean mustStartAnew = true;

    JournalLog(JournalStore store) {
        this.store = store;
    }

    /** Forgets all edits: the document is now as it was opened or saved. */
    void saved() throws IOException {
        base = null;
        mustStartAnew = true;
        store.deleteLog();
    }

    /** Returns after a state is on disk. */
    void write(Origin origin, Unsaved state) throws IOException {
        byte[] text = text(state.level());
        boolean anew = mustStartAnew || appendedBytes > LONG_LOG_BYTES + 2L * text.length;
        mustStartAnew = true;
        if (anew) {
            if (base == null) {
                base = new JournalRecord.Base(origin.time(), origin.title(), origin.file(), text(origin.level()));
            }
            store.replaceLog(JournalFormat.log(base, edit(state, base.text(), text)));
            appendedBytes = 0;
        } else {
            byte[] record = JournalFormat.framed(edit(state, written, text));
            store.appendToLog(record);
            appendedBytes += record.length;
        }
        written = text;
        mustStartAnew = false;
    }

    void picture(byte[] png) throws IOException {
        store.replacePicture(png);
    }

    private static JournalRecord.Edit edit(Unsaved state, byte[] before, byte[] text) {
        return JournalRecord.Edit.of(state.time(), state.number(), state.label(), before, text);
    }

    private static byte[] text(Level level) {
        return LevelJson.write(level).getBytes(StandardCharsets.UTF_8);
    }

    /** Returns the work of a log; empty if not even its base can be read. Without readable edits it has 0 of them. */
    static Optional<RecoverableWork> work(StoredJournal journal, byte[] log, Optional<Path> picture) {
        List<JournalRecord> records = JournalFormat.records(log);
        if (records.isEmpty() || !(records.get(0) instanceof JournalRecord.Base base)) {
            return Optional.empty();
        }
        Optional<Level> saved = level(base.text());
        if (saved.isEmpty()) {
            return Optional.empty();
        }
        State last = lastState(records, base, state -> true);
        if (last.edit != null && level(last.text).isEmpty()) {
            last = lastState(records, base, state -> level(state.text).isPresent());
        }
        Level level = last.edit == null ? saved.get() : level(last.text).orElseThrow();
        return Optional.of(new RecoverableWork(
                journal.folder(),
                base.title(),
                base.file(),
                saved.get(),
                level,
                last.edit == null ? base.time() : last.edit.time(),
                last.edit == null ? 0 : last.edit.number(),
                last.edit == null ? "" : last.edit.label(),
                picture));
    }

    private static State lastState(List<JournalRecord> records, JournalRecord.Base base, Predicate<State> good) {
        State last = new State(null, base.text());
        byte[] text = base.text();
        for (JournalRecord record : records.subList(1, records.size())) {
            if (!(record instanceof JournalRecord.Edit edit) || !edit.fits(text)) {
                return last;
            }
            text = edit.applied(text);
            State state = new State(edit, text);
            last = good.test(state) ? state : last;
        }
        return last;
    }

    private static Optional<Level> level(byte[] text) {
        try {
            return Optional.of(LevelJson.read("journal", text));
        } catch (LevelFormatException unreadable) {
            return Optional.empty();
        }
    }

    /** Returns true if a file holds this level. */
    static boolean isSaved(RecoverableWork work, byte[] content) {
        return level(content)
                .filter(level -> LevelJson.write(level).equals(LevelJson.write(work.level())))
                .isPresent();
    }
}
