package nephele.app.play;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import nephele.app.text.Phrase;
import nephele.engine.level.Language;

/** Opens a folder in the system's own window for files. */
final class FolderWindow {
    private FolderWindow() {}

    /** Makes the folder if it is missing and asks the system to show it. Returns what is told of it: its path at least. */
    static String show(Path folder, Language language) {
        try {
            Files.createDirectories(folder);
            new ProcessBuilder(command(System.getProperty("os.name"), folder))
                    .redirectErrorStream(true)
                    .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                    .start();
            return folder.toString();
        } catch (IOException nothingShowsIt) {
            return Phrase.FOLDER_NOT_SHOWN.in(language, folder);
        }
    }

    private static List<String> command(String system, Path folder) {
        String name = system.toLowerCase(Locale.ROOT);
        String opener = name.contains("windows") ? "explorer" : name.contains("mac") ? "open" : "xdg-open";
        return List.of(opener, folder.toString());
    }
}
