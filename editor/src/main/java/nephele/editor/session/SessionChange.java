package nephele.editor.session;

/** A kind of change in a session that a window shows. */
public enum SessionChange {
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
