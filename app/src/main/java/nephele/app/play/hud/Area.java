package nephele.app.play.hud;

/** The size of the picture in points: all that is drawn has room in {@value #LEAST_WIDTH} × {@value #LEAST_HEIGHT}. */
public record Area(double width, double height) {
    private static final double LEAST_WIDTH = 640;
    private static final double LEAST_HEIGHT = 360;
    /** The greatest height in points; the overlay of a higher picture is scaled up. */
    private static final double HIGHEST = 1080;

    /** Returns what a window of this size in pixels shows, see {@link #pixelsPerPoint}. */
    public static Area of(int width, int height, double screenScale) {
        double scale = pixelsPerPoint(width, height, screenScale);
        return new Area(width / scale, height / scale);
    }

    /**
     * Returns the scale of the overlay: the screen's own, but more where the picture is high, so that text stays legible,
     * and less where it is so small or narrow that texts would be clipped.
     *
     * @param screenScale pixels per point of the screen
     */
    public static double pixelsPerPoint(int width, int height, double screenScale) {
        double wanted = Math.max(screenScale, height / HIGHEST);
        return Math.min(wanted, Math.min(width / LEAST_WIDTH, height / LEAST_HEIGHT));
    }

    double centreX() {
        return width / 2;
    }

    double centreY() {
        return height / 2;
    }
}
