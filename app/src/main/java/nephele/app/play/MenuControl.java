package nephele.app.play;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.function.LongSupplier;
import nephele.app.play.hud.Area;
import nephele.app.play.hud.Menu;
import nephele.app.play.hud.MenuPanel;
import nephele.app.window.Control;
import nephele.app.window.Input;

/** Maps keys and pointer to choices in the menu; keeps the pages below the open one with their selections. */
final class MenuControl {
    /**
     * Time for which a page that opened by itself takes no input: a player who jumps and shoots up to the exit goes on
     * with it for about half a second after the page is there.
     */
    static final long UNASKED_NANOS = 700_000_000;

    /** The time after a key or a motion of the pointer in which another one is likely. */
    static final long REST_NANOS = 1_500_000_000;

    private final Input input;
    private final LongSupplier nanos;
    private final Deque<Menu> pages = new ArrayDeque<>();
    private List<Menu> closed = List.of();
    private long openedUnasked;
    private boolean isUnasked;
    private long usedLast;

    /** @param nanos the clock, as {@link System#nanoTime} */
    MenuControl(Input input, LongSupplier nanos) {
        this.input = input;
        this.nanos = nanos;
        usedLast = nanos.getAsLong() - REST_NANOS;
    }

    /** Returns true if the player has used neither keys nor pointer for a while: work may hold up the next frame. */
    boolean rests() {
        return nanos.getAsLong() - usedLast >= REST_NANOS;
    }

    /** Opens a page with no other below it. */
    void open(Menu page) {
        pages.clear();
        isUnasked = false;
        turnTo(page);
    }

    /**
     * Opens a page that the player did not ask for, with no other below it: what is pressed and clicked for the next
     * {@link #UNASKED_NANOS} was meant for the game and chooses nothing.
     */
    void openUnasked(Menu page) {
        open(page);
        isUnasked = true;
        openedUnasked = nanos.getAsLong();
    }

    /** Returns true while a page that opened by itself takes no input. */
    boolean isDeaf() {
        isUnasked &= nanos.getAsLong() - openedUnasked < UNASKED_NANOS;
        return isUnasked;
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
        pages.push(page.like(before));
    }

    /** Replaces the first page, below all others, by one with other labels. */
    void rewriteFirst(Menu page) {
        Menu before = pages.removeLast();
        pages.addLast(page.like(before));
    }

    /** Closes all pages; {@link #reopen} finds them as they were. */
    void close() {
        closed = List.copyOf(pages);
        pages.clear();
    }

    /** Opens the pages that were last closed, with their selections. */
    void reopen() {
        pages.clear();
        pages.addAll(closed);
        input.forgetMouse();
    }

    /** Returns the open page, or null. */
    Menu page() {
        return pages.peek();
    }

    /** Returns the choice made with this key, or null. */
    Menu.Choice choiceOf(Control key) {
        usedLast = nanos.getAsLong();
        if (isDeaf()) {
            return null;
        }
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
        if (isDeaf()) {
            input.forgetMouse();
            return null;
        }
        var panel = new MenuPanel(page(), area);
        int rows = input.takeScrolledRows();
        if (rows != 0) {
            pages.push(pages.pop().centredAt(panel.scrolled(rows)));
            panel = new MenuPanel(page(), area);
        }
        if (input.takePointerMoved() || rows != 0) {
            usedLast = nanos.getAsLong();
            pointAt(panel.rowAt(input.pointerX() / pixelsPerPoint, input.pointerY() / pixelsPerPoint));
        }
        var click = input.takeClick();
        int row = click == null ? -1 : panel.rowAt(click.x() / pixelsPerPoint, click.y() / pixelsPerPoint);
        if (row < 0) {
            return null;
        }
        pointAt(row);
        var step = page().stepped(panel.stepAt(row, click.x() / pixelsPerPoint));
        return step == null ? page().chosen() : step;
    }
}
