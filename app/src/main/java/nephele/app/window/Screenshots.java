package nephele.app.window;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDateTime;
import java.time.format.DateTimeFormatter;
import nephele.engine.render.Capture;
import nephele.engine.render.gl.RenderTarget;

/**
 * Screenshots of the player: saved in the user's folder for pictures, else in a checkout's build folder, else in the
 * working directory.
 */
public final class Screenshots {
    private static final DateTimeFormatter STAMP = DateTimeFormatter.ofPattern("yyyyMMdd-HHmmss-SSS");

    private final Path folder;

    public Screenshots(Path folder) {
        this.folder = folder;
    }

    public static Screenshots inUsualFolder() {
        var pictures = Path.of(System.getProperty("user.home", "."), "Pictures");
        if (Files.isDirectory(pictures)) {
            return new Screenshots(pictures.resolve("Nephele"));
        }
        var build = Path.of("build");
        return new Screenshots(Files.isDirectory(build) ? build.resolve("pictures") : Path.of("pictures"));
    }

    /**
     * Saves the target's contents.
     *
     * @return the new file
     * @throws IOException naming the file that cannot be written
     */
    public Path take(RenderTarget picture) throws IOException {
        var file = folder.resolve("nephele-" + STAMP.format(LocalDateTime.now()) + ".png");
        Capture.png(picture, file);
        return file;
    }
}
