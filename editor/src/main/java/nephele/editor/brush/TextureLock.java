package nephele.editor.brush;

/** What the pictures on a solid's faces do when it moves or turns. */
public enum TextureLock {
    /** They go with the faces. */
    LOCKED,
    /** They lie as the faces say at their new place. */
    WORLD
}
