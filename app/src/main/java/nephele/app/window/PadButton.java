package nephele.app.window;

/**
 * The buttons of a gamepad with their controls while playing and in menus, in the order of GLFW; then the triggers,
 * which GLFW counts among the axes.
 */
public enum PadButton {
    A(Control.JUMP, Control.CONFIRM),
    B(Control.CROUCH, Control.MENU),
    X(Control.CARRY, null),
    Y(Control.PERSON, null),
    LB(Control.RUN, null),
    RB(Control.THROW, null),
    SELECT(Control.HELP, Control.HELP),
    START(Control.MENU, Control.MENU),
    GUIDE(null, null),
    L3(Control.RUN, null),
    R3(null, null),
    UP(Control.GOAL, Control.FORWARD),
    RIGHT(null, Control.RIGHT),
    DOWN(Control.HINT, Control.BACK),
    LEFT(null, Control.LEFT),
    LT(Control.FIRE_SECOND, null),
    RT(Control.FIRE_FIRST, null);

    private final Control inPlay;
    private final Control inMenu;

    PadButton(Control inPlay, Control inMenu) {
        this.inPlay = inPlay;
        this.inMenu = inMenu;
    }

    /** Returns the button's control; null for none. */
    Control control(Gamepad.Use use) {
        return use == Gamepad.Use.MENU ? inMenu : inPlay;
    }

    /** Returns the name that pads have for it: the same in every language. */
    public String title() {
        return switch (this) {
            case UP -> "D-pad ↑";
            case RIGHT -> "D-pad →";
            case DOWN -> "D-pad ↓";
            case LEFT -> "D-pad ←";
            default -> name();
        };
    }

    /** Returns the button of a control while playing; null for none. */
    public static PadButton of(Control control) {
        for (PadButton button : values()) {
            if (button.inPlay == control) {
                return button;
            }
        }
        return null;
    }
}
