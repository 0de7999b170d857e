package nephele.app.window;

import static org.lwjgl.glfw.GLFW.*;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;

/**
 * The names of keys and mouse buttons. Letters and signs are those at the same place of a US keyboard, as GLFW names them.
 */
public final class KeyNames {
    private static final Map<String, Integer> CODES = codes();

    private KeyNames() {}

    /** Returns the code of a name, see {@link InputListener}; null for another text. */
    public static Integer code(String name) {
        return CODES.get(name);
    }

    /** Returns every name. */
    public static Set<String> all() {
        return CODES.keySet();
    }

    /** Returns the name of a code; null for a key without a name. */
    public static String name(int code) {
        return CODES.entrySet().stream()
                .filter(entry -> entry.getValue() == code)
                .map(Map.Entry::getKey)
                .findFirst()
                .orElse(null);
    }

    private static Map<String, Integer> codes() {
        Map<String, Integer> codes = new LinkedHashMap<>();
        for (int code = GLFW_KEY_A; code <= GLFW_KEY_Z; code++) {
            codes.put(String.valueOf((char) code), code);
        }
        for (int code = GLFW_KEY_0; code <= GLFW_KEY_9; code++) {
            codes.put(String.valueOf((char) code), code);
            codes.put("Keypad " + (char) code, code - GLFW_KEY_0 + GLFW_KEY_KP_0);
        }
        for (int number = 1; number <= 25; number++) {
            codes.put("F" + number, GLFW_KEY_F1 + number - 1);
        }
        for (char sign : "',-./;=[\\]`".toCharArray()) {
            codes.put(String.valueOf(sign), (int) sign);
        }
        for (int button = 0; button < 8; button++) {
            codes.put("Mouse " + (button + 1), InputListener.MOUSE + button);
        }
        codes.put("Space", GLFW_KEY_SPACE);
        codes.put("Escape", GLFW_KEY_ESCAPE);
        codes.put("Enter", GLFW_KEY_ENTER);
        codes.put("Tab", GLFW_KEY_TAB);
        codes.put("Backspace", GLFW_KEY_BACKSPACE);
        codes.put("Insert", GLFW_KEY_INSERT);
        codes.put("Delete", GLFW_KEY_DELETE);
        codes.put("Right", GLFW_KEY_RIGHT);
        codes.put("Left", GLFW_KEY_LEFT);
        codes.put("Down", GLFW_KEY_DOWN);
        codes.put("Up", GLFW_KEY_UP);
        codes.put("Page Up", GLFW_KEY_PAGE_UP);
        codes.put("Page Down", GLFW_KEY_PAGE_DOWN);
        codes.put("Home", GLFW_KEY_HOME);
        codes.put("End", GLFW_KEY_END);
        codes.put("Keypad .", GLFW_KEY_KP_DECIMAL);
        codes.put("Keypad /", GLFW_KEY_KP_DIVIDE);
        codes.put("Keypad *", GLFW_KEY_KP_MULTIPLY);
        codes.put("Keypad -", GLFW_KEY_KP_SUBTRACT);
        codes.put("Keypad +", GLFW_KEY_KP_ADD);
        codes.put("Keypad Enter", GLFW_KEY_KP_ENTER);
        codes.put("Left Shift", GLFW_KEY_LEFT_SHIFT);
        codes.put("Left Ctrl", GLFW_KEY_LEFT_CONTROL);
        codes.put("Left Alt", GLFW_KEY_LEFT_ALT);
        codes.put("Right Shift", GLFW_KEY_RIGHT_SHIFT);
        codes.put("Right Ctrl", GLFW_KEY_RIGHT_CONTROL);
        codes.put("Right Alt", GLFW_KEY_RIGHT_ALT);
        return Collections.unmodifiableMap(codes);
    }
}
