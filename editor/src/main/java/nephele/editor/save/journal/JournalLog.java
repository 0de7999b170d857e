package nephele.editor.save.journal;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.time.Instant;
import nephele.editor.save.DocumentFile;
import nephele.engine.level.Level;
import nephele.engine.level.json.LevelJson;

/**
 * Writes states of a document to a log: the first one as base and edit, further ones as differences. The log starts
 * anew when it has become long and after every failure, which may have left a torn record.
 */
final class JournalLog {
    private static final int LONG_LOG_BYTES = 4 << 20;

    /** The document as it was opened or last saved. */
    record Origin(String title, DocumentFile file, Level level, Instant time) {}

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
        return new JournalRecord.Edit(
                state.time(), state.number(), state.label(), JournalRecord.TextDelta.between(before, text));
    }

    private static byte[] text(Level level) {
        return LevelJson.write(level).getBytes(StandardCharsets.UTF_8);
    }
}
