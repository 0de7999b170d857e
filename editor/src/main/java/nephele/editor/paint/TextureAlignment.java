package nephele.editor.paint;

/** The edge or the middle of a face that the same edge or the middle of its picture is moved to. */
public enum TextureAlignment {
    LEFT(0),
    CENTRE(0.5),
    RIGHT(1),
    TOP(0),
    MIDDLE(0.5),
    BOTTOM(1);

    private final double fraction;

    TextureAlignment(double fraction) {
        this.fraction = fraction;
    }

    /** Returns the place on the face and on the picture: 0 at the left or top, 1 at the right or bottom. */
    double fraction() {
        return fraction;
    }

    boolean isHorizontal() {
        return this == LEFT || this == CENTRE || this == RIGHT;
    }
}
