package nephele.app.window;

/** The mode of the game's window. */
public enum WindowMode {
    WINDOWED,
    /** A window without a frame, as large as the screen. */
    BORDERLESS,
    /** Exclusive full screen, in a video mode of its own. */
    FULLSCREEN
}
