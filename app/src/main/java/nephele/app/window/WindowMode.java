package nephele.app.window;

/** The kind of window. */
public enum WindowMode {
    WINDOWED,
    /** As large as the screen and without a frame, above other windows that stay open. */
    BORDERLESS,
    /** The only picture on its screen. */
    FULLSCREEN
}
