package nephele.app.play;

import nephele.app.levels.LevelShelf;
import nephele.app.play.hud.Area;
import nephele.app.play.hud.Menu;
import nephele.app.play.hud.MenuPanel;
import nephele.app.window.Control;
import nephele.app.window.Input;

/** Turns keys and pointer into what the player chooses in the menu; pages lead to each other here. */
final class MenuControl {
    private Menu menu;

    void open() {
        menu = Menu.pause();
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
                return new Menu.Choice.Continue();
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
    Menu.Choice choiceOf(Input input, Area area, double pixelsPerPoint) {
        double x = input.pointerX() / pixelsPerPoint;
        double y = input.pointerY() / pixelsPerPoint;
        int row = new MenuPanel(menu, area).rowAt(x, y);
        if (input.takePointerMoved()) {
            menu = menu.pointedAt(row);
        }
        if (input.takeClick() && row >= 0) {
            menu = menu.pointedAt(row);
            return followed(menu.chosen());
        }
        return null;
    }

    /** Choices that only turn a page end here. */
    private Menu.Choice followed(Menu.Choice choice) {
        if (choice instanceof Menu.Choice.SelectLevel) {
            menu = Menu.levels(LevelShelf.numbered());
            return null;
        }
        if (choice instanceof Menu.Choice.Back) {
            menu = Menu.pause();
            return null;
        }
        return choice;
    }
}
