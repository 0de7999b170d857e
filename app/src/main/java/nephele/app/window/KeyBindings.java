package nephele.app.window;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;

/** The keys of each control, by name; immutable. */
public final class KeyBindings {
    /** The greatest number of keys of a control. */
    public static final int MOST_KEYS = 4;

    private final Map<Control, List<String>> keys;

    private KeyBindings(Map<Control, List<String>> keys) {
        this.keys = keys;
    }

    /** Returns the bindings with these keys; controls that are absent have none. */
    public static KeyBindings of(Map<Control, List<String>> keys) {
        Map<Control, List<String>> copy = new EnumMap<>(Control.class);
        Arrays.stream(Control.values()).forEach(control -> copy.put(control, keys.getOrDefault(control, List.of())));
        return new KeyBindings(copy);
    }

    /** Returns every control's default keys. */
    public static KeyBindings usual() {
        Map<Control, List<String>> keys = new EnumMap<>(Control.class);
        Arrays.stream(Control.values()).forEach(control -> keys.put(control, control.usualKeys()));
        return new KeyBindings(keys);
    }

    /** Returns these bindings without some keys, by name. */
    public KeyBindings without(List<String> taken) {
        Map<Control, List<String>> others = new EnumMap<>(Control.class);
        keys.forEach((control, names) -> others.put(
                control, names.stream().filter(name -> !taken.contains(name)).toList()));
        return new KeyBindings(others);
    }

    /** Returns the names of a control's keys, the first one first. */
    public List<String> keys(Control control) {
        return keys.get(control);
    }

    /** Returns the controls of a key; more than one if they conflict. */
    List<Control> controls(int code) {
        List<Control> controls = new ArrayList<>();
        keys.forEach((control, names) -> {
            if (names.stream().anyMatch(name -> KeyNames.code(name) == code)) {
                controls.add(control);
            }
        });
        return controls;
    }

    /** Returns a control that shares a key with another one; null if none does. */
    public Control conflict(Control control) {
        for (Control other : Control.values()) {
            if (other != control && keys(other).stream().anyMatch(keys(control)::contains)) {
                return other;
            }
        }
        return null;
    }

    /** Returns the keys of a control after a key replaces its first one. */
    public List<String> replaced(Control control, String key) {
        List<String> changed = new ArrayList<>(List.of(key));
        keys(control).stream().skip(1).filter(name -> !name.equals(key)).forEach(changed::add);
        return List.copyOf(changed);
    }
}
