package nephele.editor.save.journal;

import java.time.Instant;
import java.util.Arrays;
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
     * The state after an edit: the bytes of the text before that are kept at both ends, and the new ones between them. An
     * edit in one place of a level is a few lines.
     *
     * @param number of edits since the base, including those whose states were never written
     */
    record Edit(Instant time, long number, String label, int prefix, int suffix, byte[] middle)
            implements JournalRecord {
        /** Returns the edit from a text to another. */
        static Edit of(Instant time, long number, String label, byte[] old, byte[] now) {
            int shorter = Math.min(old.length, now.length);
            int mismatch = Arrays.mismatch(old, now);
            int prefix = mismatch < 0 ? shorter : mismatch;
            int suffix = 0;
            while (suffix < shorter - prefix && old[old.length - 1 - suffix] == now[now.length - 1 - suffix]) {
                suffix++;
            }
            return new Edit(time, number, label, prefix, suffix, Arrays.copyOfRange(now, prefix, now.length - suffix));
        }

        /** Returns true if the edit can be one of this text. */
        boolean fits(byte[] old) {
            return prefix >= 0 && suffix >= 0 && (long) prefix + suffix <= old.length;
        }

        /** Returns the new text. */
        byte[] applied(byte[] old) {
            byte[] now = new byte[prefix + middle.length + suffix];
            System.arraycopy(old, 0, now, 0, prefix);
            System.arraycopy(middle, 0, now, prefix, middle.length);
            System.arraycopy(old, old.length - suffix, now, prefix + middle.length, suffix);
            return now;
        }
    }
}
