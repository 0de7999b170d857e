package nephele.engine.render.frame;

/** What passes hand on to each other. */
public enum Target {
    /** What surfaces draw into: the linear picture for output HDR, else the final one. */
    SURFACE,
    /** The final 8-bit picture, display-referred. */
    PICTURE,
    SUN_SHADOW,
    LAMP_SHADOW,
    /** The sun's depth map of what moves. */
    THING_SUN_SHADOW,
    THING_LAMP_SHADOW,
    /** Light map of the static faces. */
    SKY_VISIBILITY
}
