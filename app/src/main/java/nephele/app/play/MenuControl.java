package nephele.app.play;

import java.util.ArrayDeque;
import java.util.Deque;
import nephele.app.play.hud.Area;
import nephele.app.play.hud.Menu;
import nephele.app.play.hud.MenuPanel;
import nephele.app.window.Control;
import nephele.app.window.Input;

/** Maps keys and pointer to choices in the menu; keeps the pages below the open one with their selections. */
final class MenuControl {
    private final Input input;
    private final Deque<Menu> pages = new ArrayDeque<>();

    MenuControl(Input input) {
        this.input = input;
    }

    /** Opens a page with no other below it. */
    void open(Menu page) {
        pages.clear();
        turnTo(page);
    }

    /** Opens a page above the current one. The pointer is reset, as it is now over another entry than before. */
    void turnTo(Menu page) {
        pages.push(page);
        input.forgetMouse();
    }

    /** Returns to the page below; the first page stays. Returns false if there is none below. */
    boolean back() {
        if (pages.size() == 1) {
            return false;
        }
        pages.pop();
        input.forgetMouse();
        return true;
    }

    /** Replaces the current page by one with other labels; the selection stays. */
    void rewrite(Menu page) {
        Menu before = pages.pop();
        pages.push(page.pointedAt(before.selected()));
    }

    /** Replaces the first page, below all others, by one with other labels. */
    void rewriteFirst(Menu page) {
        Menu before = pages.removeLast();
        pages.addLast(page.pointedAt(before.selected()));
    }

    void close() {
        pages.clear();
    }

    /** Returns the open page, or null. */
    Menu page() {
        return pages.peek();
    }

    /** Returns the choice made with this key, or null. */
    Menu.Choice choiceOf(Control key) {
        return switch (key) {
            case FORWARD -> moved(-1);
            case BACK -> moved(1);
            case LEFT -> page().stepped(-1);
            case RIGHT -> page().stepped(1);
            case CONFIRM, JUMP -> page().chosen();
            case MENU -> page().escape();
            default -> null;
        };
    }

    private Menu.Choice moved(int steps) {
        pages.push(pages.pop().moved(steps));
        return null;
    }

    private void pointAt(int row) {
        pages.push(pages.pop().pointedAt(row));
    }

    /**
     * Returns the choice made with the pointer, or null.
     *
     * @param pixelsPerPoint the overlay's scale
     */
    Menu.Choice choiceOf(Area area, double pixelsPerPoint) {
        var panel = new MenuPanel(page(), area);
        if (input.takePointerMoved()) {
            pointAt(panel.rowAt(input.pointerX() / pixelsPerPoint, input.pointerY() / pixelsPerPoint));
        }
        var click = input.takeClick();
        int row = click == null ? -1 : panel.rowAt(click.x() / pixelsPerPoint, click.y() / pixelsPerPoint);
        if (row < 0) {
            return null;
        }
        pointAt(row);
        return page().chosen();
    }
}
