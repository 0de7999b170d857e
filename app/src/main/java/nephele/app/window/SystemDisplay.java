package nephele.app.window;

import java.awt.AWTError;
import java.awt.GraphicsEnvironment;
import java.awt.HeadlessException;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import nephele.host.terminal.CommandFailure;

/** The display to open a window on; only X and Wayland can be absent. */
public final class SystemDisplay {
    private static final String WITHOUT_SWING =
            "this Java can't open windows; install one that can (on Debian or Ubuntu:"
                    + " apt-get install openjdk-17-jre), and don't set java.awt.headless";

    private SystemDisplay() {}

    /** Returns true if the environment names a display, which may not answer. */
    public static boolean isPresent() {
        boolean alwaysHas = isSystem("mac") || isSystem("windows");
        return alwaysHas || isSet("DISPLAY") || isSet("WAYLAND_DISPLAY");
    }

    private static boolean isSystem(String name) {
        return System.getProperty("os.name").toLowerCase(Locale.ROOT).contains(name);
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

    /** Makes a folder if it is missing and opens it in the system's window for files; returns false if that fails. */
    public static boolean show(Path folder) {
        String opener = isSystem("windows") ? "explorer" : isSystem("mac") ? "open" : "xdg-open";
        try {
            Files.createDirectories(folder);
            new ProcessBuilder(opener, folder.toString())
                    .redirectErrorStream(true)
                    .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                    .start();
            return true;
        } catch (IOException nothingShowsIt) {
            return false;
        }
    }

    private static boolean isSet(String variable) {
        var value = System.getenv(variable);
        return value != null && !value.isEmpty();
    }
}
