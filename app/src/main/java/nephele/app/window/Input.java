package nephele.app.window;

import java.util.ArrayDeque;
import java.util.EnumSet;

/**
 * What keyboard and mouse have said since they were asked last. Knows no window: the window tells it, tests too.
 * Motion is in mouse counts, positions in pixels of the picture.
 */
public final class Input implements InputListener {
    private static final int MOST_WAITING = 64;

    private final EnumSet<Control> held = EnumSet.noneOf(Control.class);
    private final EnumSet<Control> struck = EnumSet.noneOf(Control.class);
    private final ArrayDeque<Control> pressed = new ArrayDeque<>();
    private double countsRight;
    private double countsDown;
    private double lastX = Double.NaN;
    private double lastY = Double.NaN;
    private double pointerX;
    private double pointerY;
    private boolean pointerMoved;
    private boolean pointerShown;
    private Click clicked;

    @Override
    public void key(int code, boolean down) {
        for (var control : Control.values()) {
            if (control.codes().contains(code)) {
                key(control, down);
            }
        }
    }

    /** A key went down or up; repeats of a held key are not told. */
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
     * The captured mouse is at (x, y) of an endless plane. The first position after a start, a capture or a regained
     * focus only says where it is: taking it as a motion would make the view jump.
     */
    @Override
    public void look(double x, double y) {
        if (!Double.isNaN(lastX)) {
            countsRight += x - lastX;
            countsDown += y - lastY;
        }
        lastX = x;
        lastY = y;
    }

    /** Where the free pointer was when its button went down. */
    public record Click(double x, double y) {}

    /** The free pointer is over this pixel. */
    @Override
    public void point(double x, double y) {
        pointerX = x;
        pointerY = y;
        pointerMoved = true;
        pointerShown = true;
    }

    /**
     * The button went down. A pointer that has not moved since it was given back lies where nobody has put it: its first
     * click only points, so that the player sees what the next one would do.
     */
    @Override
    public void click() {
        if (pointerShown) {
            clicked = new Click(pointerX, pointerY);
        }
        pointerMoved |= !pointerShown;
        pointerShown = true;
    }

    /** Forgets every key, motion and click: the focus went away. */
    @Override
    public void forget() {
        held.clear();
        struck.clear();
        pressed.clear();
        forgetMouse();
    }

    /** Forgets motion and clicks: the mouse serves another purpose from now on. Keys keep what they have said. */
    @Override
    public void forgetMouse() {
        countsRight = 0;
        countsDown = 0;
        lastX = Double.NaN;
        lastY = Double.NaN;
        clicked = null;
        pointerMoved = false;
        pointerShown = false;
        held.removeIf(Control::isOnMouse);
        struck.removeIf(Control::isOnMouse);
    }

    public boolean holds(Control control) {
        return held.contains(control);
    }

    /** True when it is held, and once when it was pressed and let go again before anybody asked. */
    public boolean takeHold(Control control) {
        boolean wasStruck = struck.remove(control);
        return wasStruck || holds(control);
    }

    /** The next key that went down, or null. */
    public Control nextPressed() {
        return pressed.poll();
    }

    /** Motion since the last call, in counts to the right. */
    public double takeCountsRight() {
        double taken = countsRight;
        countsRight = 0;
        return taken;
    }

    /** Motion since the last call, in counts downwards. */
    public double takeCountsDown() {
        double taken = countsDown;
        countsDown = 0;
        return taken;
    }

    /** True once after the free pointer moved. */
    public boolean takePointerMoved() {
        boolean taken = pointerMoved;
        pointerMoved = false;
        return taken;
    }

    /** The last click, once; else null. */
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
