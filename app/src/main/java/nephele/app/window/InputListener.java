package nephele.app.window;

/**
 * Who is told what keyboard and mouse say. Codes are GLFW's; a mouse button is {@link #MOUSE} more. Positions are in
 * pixels of the picture, or in counts of an endless plane while the mouse is captured.
 */
public interface InputListener {
    /** Added to a mouse button's code: key codes are smaller. */
    int MOUSE = 1000;

    /** A key, or a button of the captured mouse, went down or up. */
    void key(int code, boolean down);

    /** The system repeats a held key. */
    default void repeated(int code) {}

    /** The captured mouse is at (x, y) of an endless plane. */
    default void look(double x, double y) {}

    /** The free pointer is over this pixel. */
    void point(double x, double y);

    /** The free pointer's left button went down. */
    void click();

    /** The free pointer's left button went up. */
    default void letGo() {}

    /** The focus went away or came: what is held is not known any more. */
    void forget();

    /** The mouse serves another purpose from now on. */
    default void forgetMouse() {}
}
