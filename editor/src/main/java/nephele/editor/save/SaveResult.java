package nephele.editor.save;

import java.util.List;
import nephele.editor.text.Words;

/** The result of a save; the document in memory is unchanged in every case. */
public sealed interface SaveResult {
    /**
     * The level is on disk.
     *
     * @param file the document's file from now on
     * @param notices what did not work although the level was saved
     */
    record Saved(DocumentFile file, List<Words> notices) implements SaveResult {}

    /** The file is not as it was opened or saved; nothing was written. {@code saveAs} with its path replaces it. */
    record ChangedOutside(Words question) implements SaveResult {}

    /** The level was not saved; the file on disk is unchanged. */
    record Failed(Words message) implements SaveResult {}
}
