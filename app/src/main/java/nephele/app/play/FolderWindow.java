package nephele.app.play;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** Opens a folder in the system's own window for files. */
final class FolderWindow {
    private FolderWindow() {}

    /** Makes the folder if it is missing and shows it; returns its path if nobody here can show it. */
    static Optional<Path> show(Path folder) {
        try {
            Files.createDirectories(folder);
            new ProcessBuilder(command(System.getProperty("os.name"), folder))
                    .redirectErrorStream(true)
                    .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                    .start();
            return Optional.empty();
        } catch (IOException nothingShowsIt) {
            return Optional.of(folder);
        }
    }

    private static List<String> command(String system, Path folder) {
        String name = system.toLowerCase(Locale.ROOT);
        String opener = name.contains("windows") ? "explorer" : name.contains("mac") ? "open" : "xdg-open";
        return List.of(opener, folder.toString());
    }
}
