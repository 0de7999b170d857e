package nephele.editor.session;

/** Called when something of the session has changed that a window shows. */
@FunctionalInterface
public interface SessionListener {
    /** A kind of change. */
    enum Change {
        /** Level, selection or history. */
        DOCUMENT,
        /** Panes, grid, tool, options, marks. */
        VIEW,
        /** The message in the status bar. */
        STATUS,
        /** Another file, or the file was saved. */
        FILE,
        /** Language, theme, scale, keys. */
        SETTINGS
    }

    void changed(Change change);
}
