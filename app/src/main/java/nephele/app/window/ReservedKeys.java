package nephele.app.window;

import java.util.ArrayDeque;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** Keys that are taken from their controls for a while, such as the arrows for a wipe. */
public final class ReservedKeys {
    private static final int MOST_WAITING = 64;

    private final Set<String> held = new HashSet<>();
    private final ArrayDeque<String> pressed = new ArrayDeque<>();
    private List<String> names = List.of();

    /** Reserves these keys, see {@link KeyNames}, in the place of others. */
    public void reserve(List<String> keys) {
        if (!keys.equals(names)) {
            names = keys;
            forget();
        }
    }

    /** Handles a key of any kind; returns true if no control may take its press. */
    boolean take(int code, boolean down) {
        if (names.isEmpty() && held.isEmpty()) {
            return false;
        }
        String name = KeyNames.name(code);
        if (!down) {
            held.remove(name);
            return false;
        }
        boolean isReserved = name != null && names.contains(name);
        if (isReserved) {
            held.add(name);
            if (pressed.size() < MOST_WAITING) {
                pressed.add(name);
            }
        }
        return isReserved;
    }

    public boolean holds(String name) {
        return held.contains(name);
    }

    /** Returns the name of the next key that went down, or null. */
    public String nextPressed() {
        return pressed.poll();
    }

    void forget() {
        held.clear();
        pressed.clear();
    }
}
