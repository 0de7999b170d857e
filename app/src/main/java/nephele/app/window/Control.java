package nephele.app.window;

import static org.lwjgl.glfw.GLFW.*;

import java.util.List;

/** The functions of keys and mouse buttons, in the order of the help page. */
public enum Control {
    FORWARD("W  ↑", "walk forward", GLFW_KEY_W, GLFW_KEY_UP),
    BACK("S  ↓", "walk back", GLFW_KEY_S, GLFW_KEY_DOWN),
    LEFT("A  ←", "walk left", GLFW_KEY_A, GLFW_KEY_LEFT),
    RIGHT("D  →", "walk right", GLFW_KEY_D, GLFW_KEY_RIGHT),
    RUN("Shift", "run", GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT),
    JUMP("Space", "jump", GLFW_KEY_SPACE),
    CROUCH("Ctrl  C", "crouch", GLFW_KEY_LEFT_CONTROL, GLFW_KEY_C),
    FIRE_FIRST("Left click", "first portal; throws what is held", InputListener.MOUSE + GLFW_MOUSE_BUTTON_LEFT),
    FIRE_SECOND("Right click", "second portal", InputListener.MOUSE + GLFW_MOUSE_BUTTON_RIGHT),
    CARRY("E", "pick up and let go", GLFW_KEY_E),
    THROW("F", "throw what is held", GLFW_KEY_F),
    PERSON("V", "see yourself, or through your own eyes", GLFW_KEY_V),
    RESTART("R", "start the level again", GLFW_KEY_R),
    MENU("Esc", "menu", GLFW_KEY_ESCAPE),
    CONFIRM("Enter", "choose in the menu", GLFW_KEY_ENTER, GLFW_KEY_KP_ENTER),
    HELP("F1", "this page", GLFW_KEY_F1),
    FIGURES("F3", "figures: time per pass, draws, memory", GLFW_KEY_F3),
    FULL_SCREEN("F11", "full screen", GLFW_KEY_F11),
    SCREENSHOT("F12", "picture; with Shift without the overlay", GLFW_KEY_F12);

    private final String keys;
    private final String meaning;
    private final List<Integer> codes;

    Control(String keys, String meaning, Integer... codes) {
        this.keys = keys;
        this.meaning = meaning;
        this.codes = List.of(codes);
    }

    public String keys() {
        return keys;
    }

    public String meaning() {
        return meaning;
    }

    boolean isOnMouse() {
        return codes.get(0) >= InputListener.MOUSE;
    }

    /** Returns GLFW key codes, and mouse buttons from {@link InputListener#MOUSE} on. */
    List<Integer> codes() {
        return codes;
    }
}
