package nephele.editor.save.journal;

import nephele.editor.text.Words;

/** Receives what becomes of a journal's edits, on the journal's thread. */
public interface JournalListener {
    /** Receives nothing. */
    JournalListener NONE = message -> {};

    /** Edits can't be recorded; told once, until one has been recorded again. Writing is tried again every second. */
    void failed(Words message);

    /**
     * Everything up to an edit is on disk.
     *
     * @param number of edits since the document was opened or saved
     */
    default void recorded(long number) {}
}
