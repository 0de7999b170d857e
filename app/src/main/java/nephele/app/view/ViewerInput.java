package nephele.app.view;

import java.util.ArrayDeque;
import java.util.EnumSet;
import java.util.Set;
import nephele.app.window.InputListener;
import nephele.scenes.view.ViewerKey;

/** The keyboard and mouse input of the viewer since the last query. */
final class ViewerInput implements InputListener {
    private static final int MOST_WAITING = 64;

    private final EnumSet<ViewerKey> held = EnumSet.noneOf(ViewerKey.class);
    private final EnumSet<ViewerKey> struck = EnumSet.noneOf(ViewerKey.class);
    private final ArrayDeque<ViewerKey> pressed = new ArrayDeque<>();
    private boolean dragging;
    private double x;
    private double y;
    private double draggedRight;
    private double draggedDown;

    @Override
    public void key(int code, boolean down) {
        var key = ViewerKey.of(code);
        if (key != null && down) {
            held.add(key);
            struck.add(key);
            press(key);
        } else if (key != null) {
            held.remove(key);
        }
    }

    @Override
    public void repeated(int code) {
        var key = ViewerKey.of(code);
        if (key != null && key.repeats()) {
            press(key);
        }
    }

    private void press(ViewerKey key) {
        if (pressed.size() < MOST_WAITING) {
            pressed.add(key);
        }
    }

    @Override
    public void point(double newX, double newY) {
        if (dragging) {
            draggedRight += newX - x;
            draggedDown += newY - y;
        }
        x = newX;
        y = newY;
    }

    @Override
    public void click() {
        dragging = true;
    }

    @Override
    public void letGo() {
        dragging = false;
    }

    @Override
    public void forget() {
        held.clear();
        struck.clear();
        pressed.clear();
        dragging = false;
        draggedRight = 0;
        draggedDown = 0;
    }

    /** Returns the next key that went down, or null. */
    ViewerKey nextPressed() {
        return pressed.poll();
    }

    /** Returns the keys that are down, and those that went down and up again since the last query. */
    Set<ViewerKey> takeHeld() {
        var taken = EnumSet.copyOf(held);
        taken.addAll(struck);
        struck.clear();
        return taken;
    }

    /** Returns the pixels that the pointer was dragged to the right since the last call. */
    double takeDraggedRight() {
        double taken = draggedRight;
        draggedRight = 0;
        return taken;
    }

    /** Returns the pixels that the pointer was dragged downwards since the last call. */
    double takeDraggedDown() {
        double taken = draggedDown;
        draggedDown = 0;
        return taken;
    }
}
