package nephele.editor.save.journal;

import java.io.IOException;

/** The files of one journal; tests replace it to let its operations fail. */
interface JournalStore {
    /** Replaces the log atomically; it is on disk when this returns. */
    void replaceLog(byte[] whole) throws IOException;

    /** Appends to the log, which must exist; the bytes are on disk when this returns. After a failure some may be. */
    void appendToLog(byte[] bytes) throws IOException;

    /** Replaces the picture of the document. */
    void replacePicture(byte[] png) throws IOException;

    /** Deletes the log, because nothing is unsaved any more. */
    void deleteLog() throws IOException;

    /** Lets other processes find the journal. */
    void release();

    /** Deletes everything. */
    void delete();
}
