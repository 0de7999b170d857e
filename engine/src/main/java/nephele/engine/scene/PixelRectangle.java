package nephele.engine.scene;

/** A rectangle of pixels, counted from the picture's lower left corner; reused from frame to frame. */
public final class PixelRectangle {
    private int x;
    private int y;
    private int width;
    private int height;

    void whole(int pictureWidth, int pictureHeight) {
        set(0, 0, pictureWidth, pictureHeight);
    }

    private void set(int newX, int newY, int newWidth, int newHeight) {
        x = newX;
        y = newY;
        width = newWidth;
        height = newHeight;
    }

    /** Sets this to the pixels that {@code polygon} may touch and one more on every side, clipped to {@code outer}. */
    void around(PicturePolygon polygon, int pictureWidth, int pictureHeight, PixelRectangle outer) {
        int left = Math.max(pixel(-polygon.support(-1, 0), pictureWidth) - 1, outer.x);
        int bottom = Math.max(pixel(-polygon.support(0, -1), pictureHeight) - 1, outer.y);
        int right = Math.min(pixel(polygon.support(1, 0), pictureWidth) + 2, outer.x + outer.width);
        int top = Math.min(pixel(polygon.support(0, 1), pictureHeight) + 2, outer.y + outer.height);
        set(left, bottom, Math.max(right - left, 0), Math.max(top - bottom, 0));
    }

    private static int pixel(double inPicture, int pixels) {
        return (int) Math.floor((inPicture + 1) / 2 * pixels);
    }

    public int x() {
        return x;
    }

    public int y() {
        return y;
    }

    public int width() {
        return width;
    }

    public int height() {
        return height;
    }
}
