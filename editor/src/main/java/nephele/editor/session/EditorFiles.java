package nephele.editor.session;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Consumer;
import nephele.host.userfile.UserFile;
import nephele.host.userfile.UserFolders;

/**
 * The places of the editor's own files in the user's folders.
 *
 * @param settings {@code editor.json}; {@code null} if there is no place for it, nothing is then kept
 * @param journals folder of the edits that are not saved
 * @param backups folder of the previous versions of saved levels
 * @param fault file that tells of the last fault of the program
 */
public record EditorFiles(Path settings, Path journals, Path backups, Path fault) {
    /** Returns the places in a user's folders; without a folder of state, they are in that of temporary files. */
    public static EditorFiles in(UserFolders folders) {
        Path state = Optional.ofNullable(folders.state())
                .orElseGet(() -> Path.of(System.getProperty("java.io.tmpdir"), "nephele"));
        Path settings = folders.settings();
        return of(settings == null ? null : settings.resolve("editor.json"), state.resolve("editor"));
    }

    /** Returns the places in a folder, and that of the settings, {@code null} if they are not kept. */
    public static EditorFiles of(Path settings, Path folder) {
        return new EditorFiles(
                settings, folder.resolve("journal"), folder.resolve("backups"), folder.resolve("fault.txt"));
    }

    /**
     * Reads the settings; never fails.
     *
     * @param report receives a line for each problem, which names the file
     */
    public EditorSettings read(Consumer<String> report) {
        return EditorSettings.of(file().read(report), problem -> report.accept(settings + ": " + problem));
    }

    /**
     * Saves the settings atomically.
     *
     * @throws IOException with a message for users that names the file and the reason; the file is then unchanged
     */
    public void save(EditorSettings chosen) throws IOException {
        file().save(chosen.entries());
    }

    private UserFile file() {
        return new UserFile(settings, "nephele-editor-settings", 1);
    }
}
