package nephele.app.window;

import java.awt.AWTError;
import java.awt.GraphicsEnvironment;
import java.awt.HeadlessException;
import java.util.Locale;
import nephele.engine.terminal.CommandFailure;

/** The display to open a window on; only X and Wayland can be absent. */
public final class SystemDisplay {
    private static final String WITHOUT_SWING =
            "this Java can't open windows; install one that can (on Debian or Ubuntu:"
                    + " apt-get install openjdk-17-jre), and don't set java.awt.headless";

    private SystemDisplay() {}

    /** Returns true if the environment names a display, which may not answer. */
    public static boolean isPresent() {
        var system = System.getProperty("os.name").toLowerCase(Locale.ROOT);
        boolean alwaysHas = system.contains("mac") || system.contains("windows");
        return alwaysHas || isSet("DISPLAY") || isSet("WAYLAND_DISPLAY");
    }

    /**
     * Connects Swing to the display.
     *
     * @param otherwise advice for a user without a display
     * @throws CommandFailure if Swing can't open windows here (exit code 3)
     */
    public static void requireForSwing(String otherwise) {
        try {
            if (!GraphicsEnvironment.isHeadless()) {
                GraphicsEnvironment.getLocalGraphicsEnvironment().getDefaultScreenDevice();
                return;
            }
        } catch (AWTError | HeadlessException noServer) {
            throw unavailable("X11: Failed to open display " + System.getenv("DISPLAY"), otherwise);
        } catch (LinkageError noLibrary) {
            throw CommandFailure.environment(WITHOUT_SWING + "; " + otherwise, noLibrary);
        }
        if (isSet("DISPLAY")) {
            throw CommandFailure.environment(WITHOUT_SWING + "; " + otherwise);
        }
        throw unavailable("DISPLAY names none (Swing needs X11; on Wayland, Xwayland)", otherwise);
    }

    /**
     * Returns the failure of a program whose display doesn't answer.
     *
     * @param reason the window system's own words
     * @param otherwise advice for a user without a display
     */
    static CommandFailure unavailable(String reason, String otherwise) {
        return CommandFailure.environment("no display can be opened: " + reason
                + "; start an X server there, or set DISPLAY to one that this user may use; " + otherwise);
    }

    private static boolean isSet(String variable) {
        var value = System.getenv(variable);
        return value != null && !value.isEmpty();
    }
}
