package nephele.editor.action;

import java.awt.GraphicsEnvironment;
import java.awt.Toolkit;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import javax.swing.KeyStroke;

/**
 * A key with modifiers, such as {@code Ctrl+Shift+D}, {@code F5}, {@code Delete} or {@code +}. Ctrl is the key of the
 * platform's menus: Command on macOS.
 *
 * @param key an upper-case letter, a digit, another character, or a name such as {@code PageUp}
 */
public record KeyText(boolean isCtrl, boolean isShift, boolean isAlt, String key) {
    private static final Map<String, Integer> NAMED = named();

    /** Words for keys that have a shorter name, in lower case. */
    private static final Map<String, String> OTHER_NAMES = Map.of(
            "escape",
            "Esc",
            "openbracket",
            "[",
            "closebracket",
            "]",
            "minus",
            "-",
            "plus",
            "+",
            "comma",
            ",",
            "period",
            ".",
            "slash",
            "/");

    private static Map<String, Integer> named() {
        Map<String, Integer> codes = new TreeMap<>(String.CASE_INSENSITIVE_ORDER);
        codes.put("Enter", KeyEvent.VK_ENTER);
        codes.put("Esc", KeyEvent.VK_ESCAPE);
        codes.put("Delete", KeyEvent.VK_DELETE);
        codes.put("Backspace", KeyEvent.VK_BACK_SPACE);
        codes.put("Insert", KeyEvent.VK_INSERT);
        codes.put("Space", KeyEvent.VK_SPACE);
        codes.put("Tab", KeyEvent.VK_TAB);
        codes.put("Home", KeyEvent.VK_HOME);
        codes.put("End", KeyEvent.VK_END);
        codes.put("PageUp", KeyEvent.VK_PAGE_UP);
        codes.put("PageDown", KeyEvent.VK_PAGE_DOWN);
        codes.put("Up", KeyEvent.VK_UP);
        codes.put("Down", KeyEvent.VK_DOWN);
        codes.put("Left", KeyEvent.VK_LEFT);
        codes.put("Right", KeyEvent.VK_RIGHT);
        for (int i = 1; i <= 12; i++) {
            codes.put("F" + i, KeyEvent.VK_F1 + i - 1);
        }
        return codes;
    }

    /** Reads a text; empty if it names no key. Case and blanks around {@code +} do not matter. */
    public static Optional<KeyText> parse(String text) {
        String trimmed = text.trim();
        boolean endsInPlus = trimmed.equals("+") || trimmed.endsWith("++");
        String modifiers = endsInPlus ? trimmed.substring(0, trimmed.length() - 1) : trimmed;
        List<String> parts = new ArrayList<>(Arrays.stream(modifiers.split("\\+"))
                .map(String::trim)
                .filter(part -> !part.isEmpty())
                .toList());
        String key = endsInPlus ? "+" : parts.isEmpty() ? "" : parts.remove(parts.size() - 1);
        List<String> held =
                parts.stream().map(part -> part.toLowerCase(Locale.ROOT)).toList();
        boolean isKnown = List.of("ctrl", "shift", "alt").containsAll(held);
        return isKnown
                ? key(key).map(known ->
                        new KeyText(held.contains("ctrl"), held.contains("shift"), held.contains("alt"), known))
                : Optional.empty();
    }

    /** Returns the key that was pressed; empty for a modifier alone and for what no text names. */
    public static Optional<KeyText> pressed(KeyEvent event) {
        boolean isCtrl = isMenuKeyHeld(event);
        Optional<String> name = NAMED.entrySet().stream()
                .filter(named -> named.getValue() == event.getKeyCode())
                .map(Map.Entry::getKey)
                .findFirst();
        if (name.isPresent()) {
            return name.map(named -> new KeyText(isCtrl, event.isShiftDown(), event.isAltDown(), named));
        }
        int code = event.getKeyCode();
        if (code >= KeyEvent.VK_0 && code <= KeyEvent.VK_Z && Character.isLetterOrDigit(code)) {
            return Optional.of(
                    new KeyText(isCtrl, event.isShiftDown(), event.isAltDown(), String.valueOf((char) code)));
        }
        char sign = event.getKeyChar();
        boolean isWritten = sign != KeyEvent.CHAR_UNDEFINED && !Character.isISOControl(sign);
        if (isWritten && !Character.isWhitespace(sign)) {
            // Shift and AltGr write a sign, on some layouts.
            boolean isAlt = event.isAltDown() && !event.isAltGraphDown();
            return key(String.valueOf(sign)).map(text -> new KeyText(isCtrl, false, isAlt, text));
        }
        boolean isSign = code >= KeyEvent.VK_COMMA && code <= KeyEvent.VK_CLOSE_BRACKET;
        return isSign
                ? key(String.valueOf((char) code)).map(text -> new KeyText(isCtrl, false, false, text))
                : Optional.empty();
    }

    private static Optional<String> key(String text) {
        if (text.length() == 1 && !Character.isWhitespace(text.charAt(0))) {
            return Optional.of(text.toUpperCase(Locale.ROOT));
        }
        Optional<String> other = Optional.ofNullable(OTHER_NAMES.get(text.toLowerCase(Locale.ROOT)));
        if (other.isPresent()) {
            return other;
        }
        return NAMED.keySet().stream().filter(text::equalsIgnoreCase).findFirst();
    }

    /** Returns the text from which it can be read. */
    public String text() {
        return (isCtrl ? "Ctrl+" : "") + (isShift ? "Shift+" : "") + (isAlt ? "Alt+" : "") + key;
    }

    /** Returns true if neither Ctrl nor Alt is part of it and the key writes a character or moves a text cursor. */
    public boolean isPlain() {
        return !isCtrl && !isAlt && !key.matches("F\\d+");
    }

    /** Returns true if the key that was pressed bears this character in the user's layout. */
    boolean isByCharacter(KeyEvent event) {
        Integer named = NAMED.get(key);
        if (named != null) {
            return event.getKeyCode() == named && isShift == event.isShiftDown() && areOthersHeld(event);
        }
        char character = key.charAt(0);
        if (Character.isLetterOrDigit(character)) {
            return event.getExtendedKeyCode() == KeyEvent.getExtendedKeyCodeForChar(character)
                    && isShift == event.isShiftDown()
                    && areOthersHeld(event);
        }
        return event.getKeyChar() == character && isShift == event.isShiftDown() && areOthersHeld(event);
    }

    /** Returns true if this sign was written with Shift or AltGr, which some layouts need for it. */
    boolean isByWrittenSign(KeyEvent event) {
        boolean isSign = !NAMED.containsKey(key) && !Character.isLetterOrDigit(key.charAt(0));
        boolean isAltHeld = event.isAltDown() && !event.isAltGraphDown();
        return isSign && event.getKeyChar() == key.charAt(0) && isCtrl == isMenuKeyHeld(event) && (isAlt || !isAltHeld);
    }

    /** Returns true if the key that was pressed is where a US layout has this character. */
    boolean isByPosition(KeyEvent event) {
        return event.getKeyCode() == keyCode() && isShift == event.isShiftDown() && areOthersHeld(event);
    }

    private boolean areOthersHeld(KeyEvent event) {
        return isCtrl == isMenuKeyHeld(event) && isAlt == event.isAltDown();
    }

    private static boolean isMenuKeyHeld(KeyEvent event) {
        return (event.getModifiersEx() & menuMask()) != 0;
    }

    private static int menuMask() {
        return GraphicsEnvironment.isHeadless()
                ? InputEvent.CTRL_DOWN_MASK
                : Toolkit.getDefaultToolkit().getMenuShortcutKeyMaskEx();
    }

    private int keyCode() {
        Integer named = NAMED.get(key);
        return named != null ? named : KeyEvent.getExtendedKeyCodeForChar(key.charAt(0));
    }

    /** Returns the stroke, as menus show it. */
    public KeyStroke stroke() {
        int modifiers = (isCtrl ? menuMask() : 0)
                | (isShift ? InputEvent.SHIFT_DOWN_MASK : 0)
                | (isAlt ? InputEvent.ALT_DOWN_MASK : 0);
        return KeyStroke.getKeyStroke(keyCode(), modifiers);
    }
}
