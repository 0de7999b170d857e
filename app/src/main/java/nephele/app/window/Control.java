package nephele.app.window;

import java.util.List;

/** The functions of keys and mouse buttons, in the order of the help page. */
public enum Control {
    FORWARD("W", "Up"),
    BACK("S", "Down"),
    LEFT("A", "Left"),
    RIGHT("D", "Right"),
    RUN("Left Shift", "Right Shift"),
    JUMP("Space"),
    CROUCH("Left Ctrl", "C"),
    FIRE_FIRST("Mouse 1"),
    FIRE_SECOND("Mouse 2"),
    CARRY("E"),
    THROW("F"),
    PERSON("V"),
    GOAL("Tab"),
    HINT("H"),
    RESTART("R"),
    MENU("Escape"),
    CONFIRM("Enter", "Keypad Enter"),
    HELP("F1"),
    FIGURES("F3"),
    FULL_SCREEN("F11"),
    SCREENSHOT("F12");

    private final List<String> usualKeys;

    Control(String... usualKeys) {
        this.usualKeys = List.of(usualKeys);
    }

    /** Returns the names of the default keys, see {@link KeyNames}. */
    public List<String> usualKeys() {
        return usualKeys;
    }

    /** Returns false for the keys of menus, which stay so that every menu can be left. */
    public boolean canBeChanged() {
        return this != MENU && this != CONFIRM;
    }
}
