package nephele.app.window;

/** The size of a window or of a screen's picture, in screen units. */
public record WindowSize(int width, int height) {}
