package nephele.app.window;

/**
 * A listener for keyboard and mouse events. Codes are GLFW's; mouse buttons have {@link #MOUSE} added. Positions are in
 * framebuffer pixels, or in counts on an unbounded plane while the mouse is captured.
 */
public interface InputListener {
    /** Added to the code of a mouse button; it is greater than all key codes. */
    int MOUSE = 1000;

    /** Called when a key, or a button of the captured mouse, goes down or up. */
    void key(int code, boolean down);

    /** Called when the system repeats a held key. */
    default void repeated(int code) {}

    /** Called when the captured mouse is at (x, y) of an unbounded plane. */
    default void look(double x, double y) {}

    /** Called when the free pointer is over this pixel. */
    void point(double x, double y);

    /** Called when the free pointer's left button goes down. */
    void click();

    /** Called when the free pointer's left button goes up. */
    default void letGo() {}

    /** Called when the wheel has turned by so many notches, or parts of one, away from the player. */
    default void scroll(double up) {}

    /** Called when the focus is lost or gained: the held keys are unknown from then on. */
    void forget();

    /** Called when the use of the mouse changes (captured or free). */
    default void forgetMouse() {}
}
