package nephele.app.window;

import java.util.ArrayDeque;
import java.util.EnumSet;

/**
 * The keyboard and mouse input since the last query. It does not depend on a window: the window feeds it, tests do too.
 * Motion is in mouse counts, positions are in framebuffer pixels.
 */
public final class Input implements InputListener {
    private static final int MOST_WAITING = 64;

    private final EnumSet<Control> held = EnumSet.noneOf(Control.class);
    private final EnumSet<Control> struck = EnumSet.noneOf(Control.class);
    private final ArrayDeque<Control> pressed = new ArrayDeque<>();
    private final ReservedKeys reserved = new ReservedKeys();
    private double countsRight;
    private double countsDown;
    private double lastX = Double.NaN;
    private double lastY = Double.NaN;
    private double pointerX;
    private double pointerY;
    private double scrolledUp;
    private boolean pointerMoved;
    private boolean pointerShown;
    private Click clicked;
    private KeyBindings bindings = KeyBindings.usual();
    private Device device = Device.KEYBOARD;
    private double walkForward;
    private double walkRight;
    private boolean capturing;
    private Integer captured;

    /** The device that the player used last. */
    public enum Device {
        /** Keyboard and mouse. */
        KEYBOARD,
        GAMEPAD
    }

    public Device device() {
        return device;
    }

    /** Returns the keys that no control takes. */
    public ReservedKeys reserved() {
        return reserved;
    }

    /** Replaces the keys of all controls; keys that are held count as released. */
    public void bind(KeyBindings changed) {
        bindings = changed;
        forget();
    }

    /** Takes the next key or mouse button for {@link #takeCaptured} instead of its control. */
    public void capture() {
        capturing = true;
        captured = null;
    }

    /** Ends a capture as the Esc key would. */
    void cancelCapture() {
        capturing = false;
        captured = KeyNames.code("Escape");
        device = Device.GAMEPAD;
    }

    /** Returns true while the key of {@link #capture} has not come. */
    public boolean isCapturing() {
        return capturing;
    }

    /** Returns the code of the captured key, once; else null. */
    public Integer takeCaptured() {
        Integer taken = captured;
        captured = null;
        return taken;
    }

    @Override
    public void key(int code, boolean down) {
        device = Device.KEYBOARD;
        if (capturing && down) {
            capturing = false;
            captured = code;
            return;
        }
        if (reserved.take(code, down)) {
            return;
        }
        for (var control : bindings.controls(code)) {
            key(control, down);
        }
    }

    /** Handles a button of a gamepad. */
    void padControl(Control control, boolean down) {
        device = Device.GAMEPAD;
        key(control, down);
    }

    /** Handles the state of a stick that walks, −1 to 1 each. */
    void walk(double forward, double right) {
        walkForward = forward;
        walkRight = right;
        device = forward == 0 && right == 0 ? device : Device.GAMEPAD;
    }

    /** Turns the view as motion of the mouse would, in counts. */
    void turn(double right, double down) {
        countsRight += right;
        countsDown += down;
        device = right == 0 && down == 0 ? device : Device.GAMEPAD;
    }

    /** Handles a control that went down or up; repeats of a held key are not reported. */
    public void key(Control control, boolean down) {
        if (!down) {
            held.remove(control);
            return;
        }
        held.add(control);
        struck.add(control);
        if (pressed.size() < MOST_WAITING) {
            pressed.add(control);
        }
    }

    /**
     * Handles a position (x, y) of the captured mouse on an unbounded plane. The first position after a start, a
     * capture or a regained focus is only the reference: as a motion it would make the view jump.
     */
    @Override
    public void look(double x, double y) {
        if (!Double.isNaN(lastX)) {
            device = Device.KEYBOARD;
            countsRight += x - lastX;
            countsDown += y - lastY;
        }
        lastX = x;
        lastY = y;
    }

    /** The position of the free pointer when its button went down. */
    public record Click(double x, double y) {}

    /** Handles a position of the free pointer. */
    @Override
    public void point(double x, double y) {
        pointerX = x;
        pointerY = y;
        pointerMoved = true;
        pointerShown = true;
    }

    /**
     * Handles a press of the left button. The place of a pointer that has not moved since its release is arbitrary: its
     * first click only points, so that the player sees what the next one would select.
     */
    @Override
    public void click() {
        if (capturing) {
            key(MOUSE, true);
            return;
        }
        if (pointerShown) {
            clicked = new Click(pointerX, pointerY);
        }
        pointerMoved |= !pointerShown;
        pointerShown = true;
    }

    /** Handles a turn of the wheel; a touch pad gives parts of a notch, which add up. */
    @Override
    public void scroll(double up) {
        scrolledUp += up;
    }

    /** Returns the rows by which the wheel has moved a list since the last call, downwards. */
    public int takeScrolledRows() {
        int up = (int) scrolledUp;
        scrolledUp -= up;
        return -up;
    }

    /** Clears all keys, motion and clicks, after a loss of focus. */
    @Override
    public void forget() {
        held.clear();
        struck.clear();
        pressed.clear();
        reserved.forget();
        walk(0, 0);
        forgetMouse();
    }

    /** Clears motion, clicks and mouse buttons when the use of the mouse changes. Keys are kept. */
    @Override
    public void forgetMouse() {
        countsRight = 0;
        countsDown = 0;
        lastX = Double.NaN;
        lastY = Double.NaN;
        clicked = null;
        scrolledUp = 0;
        pointerMoved = false;
        pointerShown = false;
        held.removeIf(this::isOnMouse);
        struck.removeIf(this::isOnMouse);
    }

    private boolean isOnMouse(Control control) {
        return bindings.keys(control).stream().anyMatch(name -> KeyNames.code(name) >= MOUSE);
    }

    public boolean holds(Control control) {
        return held.contains(control);
    }

    /** Returns true if the control is held, and once if it was pressed and released since the last query. */
    public boolean takeHold(Control control) {
        boolean wasStruck = struck.remove(control);
        return wasStruck || holds(control);
    }

    /** Forgets presses that nothing has taken yet, such as those in a menu; what is held stays held. */
    public void forgetPresses() {
        struck.clear();
    }

    /** Returns the next control that went down, or null. */
    public Control nextPressed() {
        return pressed.poll();
    }

    /** Returns the state of the stick that walks, −1 (back) to 1. */
    public double walkForward() {
        return walkForward;
    }

    /** Returns the state of the stick that walks, −1 (left) to 1. */
    public double walkRight() {
        return walkRight;
    }

    /** Returns the motion since the last call, in counts to the right. */
    public double takeCountsRight() {
        double taken = countsRight;
        countsRight = 0;
        return taken;
    }

    /** Returns the motion since the last call, in counts downwards. */
    public double takeCountsDown() {
        double taken = countsDown;
        countsDown = 0;
        return taken;
    }

    /** Returns true once after the free pointer moved. */
    public boolean takePointerMoved() {
        boolean taken = pointerMoved;
        pointerMoved = false;
        return taken;
    }

    /** Returns the last click, once; else null. */
    public Click takeClick() {
        Click taken = clicked;
        clicked = null;
        return taken;
    }

    public double pointerX() {
        return pointerX;
    }

    public double pointerY() {
        return pointerY;
    }
}
