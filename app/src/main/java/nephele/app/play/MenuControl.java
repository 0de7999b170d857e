package nephele.app.play;

import nephele.app.play.hud.Area;
import nephele.app.play.hud.Menu;
import nephele.app.play.hud.MenuPanel;
import nephele.app.window.Control;
import nephele.app.window.Input;
import nephele.engine.named.LevelCatalogue;

/** Maps keys and pointer to choices in the menu, and switches between its pages. */
final class MenuControl {
    private final Input input;
    private Menu menu;

    MenuControl(Input input) {
        this.input = input;
    }

    void open() {
        turnTo(Menu.pause());
    }

    /** Opens a page. The pointer is reset, as it is now over another entry than the player placed it on. */
    void turnTo(Menu page) {
        menu = page;
        input.forgetMouse();
    }

    /** Replaces the page by one with other labels; the selection stays. */
    void rewrite(Menu page) {
        menu = page.pointedAt(menu.selected());
    }

    void close() {
        menu = null;
    }

    /** Returns the open page, or null. */
    Menu page() {
        return menu;
    }

    /** Returns the choice made with this key, or null. */
    Menu.Choice choiceOf(Control key) {
        switch (key) {
            case FORWARD -> menu = menu.moved(-1);
            case BACK -> menu = menu.moved(1);
            case CONFIRM, JUMP -> {
                return followed(menu.chosen());
            }
            case MENU -> {
                return followed(menu.escape());
            }
            default -> {}
        }
        return null;
    }

    /**
     * Returns the choice made with the pointer, or null.
     *
     * @param pixelsPerPoint the overlay's scale
     */
    Menu.Choice choiceOf(Area area, double pixelsPerPoint) {
        var panel = new MenuPanel(menu, area);
        if (input.takePointerMoved()) {
            menu = menu.pointedAt(panel.rowAt(input.pointerX() / pixelsPerPoint, input.pointerY() / pixelsPerPoint));
        }
        var click = input.takeClick();
        int row = click == null ? -1 : panel.rowAt(click.x() / pixelsPerPoint, click.y() / pixelsPerPoint);
        if (row < 0) {
            return null;
        }
        menu = menu.pointedAt(row);
        return followed(menu.chosen());
    }

    /** Handles choices that only open a page; returns the others. */
    private Menu.Choice followed(Menu.Choice choice) {
        if (choice instanceof Menu.Choice.SelectLevel) {
            turnTo(Menu.levels(LevelCatalogue.numbered()));
            return null;
        }
        if (choice instanceof Menu.Choice.Back) {
            turnTo(Menu.pause());
            return null;
        }
        return choice;
    }
}
