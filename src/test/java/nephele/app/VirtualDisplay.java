package nephele.app;

import static org.junit.jupiter.api.Assertions.fail;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.util.ArrayList;
import java.util.List;

/** An X display for tests (Xvfb), independent of any display of the machine. */
public final class VirtualDisplay implements AutoCloseable {
    private final Process xvfb;
    private final String name;

    private VirtualDisplay(Process xvfb, String name) {
        this.xvfb = xvfb;
        this.name = name;
    }

    /** Starts a display of 1024 × 600 pixels. */
    public static VirtualDisplay start() throws IOException {
        return start("1024x600", "+extension", "GLX");
    }

    /** Starts a display of a size, such as {@code 1280x800}. */
    public static VirtualDisplay ofSize(String size) throws IOException {
        return start(size, "+extension", "GLX");
    }

    /** Starts a display on which windows cannot have OpenGL. */
    public static VirtualDisplay startWithoutOpenGl() throws IOException {
        return start("1024x600", "-extension", "GLX");
    }

    private static VirtualDisplay start(String size, String... options) throws IOException {
        Process xvfb = null;
        List<String> command =
                new ArrayList<>(List.of("Xvfb", "-displayfd", "1", "-screen", "0", size + "x24", "-nolisten", "tcp"));
        command.addAll(List.of(options));
        try {
            xvfb = new ProcessBuilder(command)
                    .redirectError(ProcessBuilder.Redirect.DISCARD)
                    .start();
        } catch (IOException missing) {
            fail("Xvfb is not installed; this test needs it: apt-get install xvfb (./nephele test does it)");
        }
        var reader = new BufferedReader(new InputStreamReader(xvfb.getInputStream()));
        return new VirtualDisplay(xvfb, ":" + reader.readLine());
    }

    /** Returns the value of {@code DISPLAY}. */
    public String name() {
        return name;
    }

    @Override
    public void close() {
        xvfb.destroy();
    }
}
