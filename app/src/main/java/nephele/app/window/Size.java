package nephele.app.window;

/** The size of a window or picture in pixels, written {@code 1280x720}. */
public record Size(int width, int height) {
    public static final Size DEFAULT = new Size(1280, 720);
    private static final int GREATEST = 16384;

    /**
     * Reads {@code WxH}.
     *
     * @throws IllegalArgumentException with a sentence about what is wrong
     */
    public static Size parse(String text) {
        String[] parts = text.split("x", -1);
        if (parts.length != 2 || !parts[0].matches("[0-9]{1,5}") || !parts[1].matches("[0-9]{1,5}")) {
            throw new IllegalArgumentException("'" + text + "' is not a size such as 1280x720");
        }
        var size = new Size(Integer.parseInt(parts[0]), Integer.parseInt(parts[1]));
        boolean drawable = Math.min(size.width, size.height) >= 1 && Math.max(size.width, size.height) <= GREATEST;
        if (!drawable) {
            throw new IllegalArgumentException("'" + text + "' must lie between 1x1 and " + GREATEST + "x" + GREATEST);
        }
        return size;
    }
}
