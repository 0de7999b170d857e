package nephele.editor.surface;

/** The requested surface: {@code --viewport auto|awt|offscreen}. */
public enum SurfaceMode {
    /** A canvas where it works, otherwise an offscreen picture. */
    AUTO,
    /** A canvas of the window system. */
    AWT,
    /** A picture drawn offscreen, which also works without a display. */
    OFFSCREEN
}
