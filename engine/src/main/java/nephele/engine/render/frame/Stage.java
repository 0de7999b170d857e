package nephele.engine.render.frame;

/** When in a frame a pass draws; the order of the stages is the order of the frame. */
public enum Stage {
    /** Before the first view: what all views use. */
    ONCE_A_FRAME,
    /** In each view, through portals too: what hides what is behind it, and the sky. */
    IN_VIEWS,
    /**
     * In each view after its opaque surfaces, when what is seen through its portals has been drawn: may read {@link
     * Target#VIEW_DEPTH} and {@link Target#VIEW_COLOUR}.
     */
    IN_VIEWS_AFTER_OPAQUE,
    /** When all views have been drawn and their samples averaged. */
    AFTER_ALL
}
