package nephele.app.play;

import nephele.app.play.hud.Area;
import nephele.app.play.hud.Menu;
import nephele.app.play.hud.MenuPanel;
import nephele.app.window.Control;
import nephele.app.window.Input;
import nephele.engine.named.LevelShelf;

/** Turns keys and pointer into what the player chooses in the menu; pages lead to each other here. */
final class MenuControl {
    private final Input input;
    private Menu menu;

    MenuControl(Input input) {
        this.input = input;
    }

    void open() {
        turnTo(Menu.pause());
    }

    /** What lies under the pointer now is another entry than the one that it was put on. */
    void turnTo(Menu page) {
        menu = page;
        input.forgetMouse();
    }

    /** The same page with other words. */
    void rewrite(Menu page) {
        menu = page.pointedAt(menu.selected());
    }

    void close() {
        menu = null;
    }

    /** The page that is open, or null. */
    Menu page() {
        return menu;
    }

    /** What this key chooses, or null. */
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
     * What the pointer chooses, or null.
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

    /** Choices that only turn a page end here. */
    private Menu.Choice followed(Menu.Choice choice) {
        if (choice instanceof Menu.Choice.SelectLevel) {
            turnTo(Menu.levels(LevelShelf.numbered()));
            return null;
        }
        if (choice instanceof Menu.Choice.Back) {
            turnTo(Menu.pause());
            return null;
        }
        return choice;
    }
}
