package nephele.app.window;

import java.util.Locale;

/** Tests for a display to open a window on; only X and Wayland can be absent. */
public final class SystemDisplay {
    private SystemDisplay() {}

    public static boolean isPresent() {
        var system = System.getProperty("os.name").toLowerCase(Locale.ROOT);
        boolean alwaysHas = system.contains("mac") || system.contains("windows");
        return alwaysHas || isSet("DISPLAY") || isSet("WAYLAND_DISPLAY");
    }

    private static boolean isSet(String variable) {
        var value = System.getenv(variable);
        return value != null && !value.isEmpty();
    }
}
