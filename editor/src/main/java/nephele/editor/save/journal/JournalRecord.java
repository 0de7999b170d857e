package nephele.editor.save.journal;

import java.time.Instant;
import nephele.editor.save.DocumentFile;

/** A record of a journal's log. */
sealed interface JournalRecord {
    /**
     * The first record: the document as it was opened or last saved.
     *
     * @param text the level in its canonical JSON text
     */
    record Base(Instant time, String title, DocumentFile file, byte[] text) implements JournalRecord {}

    /**
     * The state after an edit.
     *
     * @param number of edits since the base, including those whose states were never written
     * @param delta from the text of the record before
     */
    record Edit(Instant time, long number, String label, TextDelta delta) implements JournalRecord {}
}
