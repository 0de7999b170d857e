package nephele.editor.brush;

/** The anchor of the textures of a solid that moves or turns. */
public enum TextureLock {
    /** They go with the faces. */
    LOCKED,
    /** They lie as the faces say at their new place. */
    WORLD
}
