package nephele.engine.render.frame;

/** The time of a pass in a frame; the order of the stages is the order of the frame. */
public enum Stage {
    /** Before the first view: passes that all views share. */
    ONCE_A_FRAME,
    /** In each view, also nested ones: opaque surfaces and the sky. */
    IN_VIEWS,
    /**
     * In each view after its opaque surfaces and its nested views; may read {@link Target#VIEW_DEPTH} and {@link
     * Target#VIEW_COLOUR}.
     */
    IN_VIEWS_AFTER_OPAQUE,
    /** Once, after all views have been drawn and their samples averaged; reads that picture and leaves it as it is. */
    AFTER_VIEWS,
    /** After that: each pass reads a picture and writes the next one. */
    AFTER_ALL
}
