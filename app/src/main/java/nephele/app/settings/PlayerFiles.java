package nephele.app.settings;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import nephele.host.userfile.UserFile;
import nephele.host.userfile.UserFolders;

/** Settings, progress and learned quality of a player, each in a file of its own; each change is saved at once. */
public final class PlayerFiles {
    private final UserFile settingsFile;
    private final UserFile progressFile;
    private final UserFile qualityFile;
    private final Path levels;
    private final List<String> problems = new ArrayList<>();
    private GameSettings settings;
    private Progress progress;
    private QualityMemory quality;

    /** Reads the files; problems with them are returned by {@link #takeProblems}. */
    public PlayerFiles(UserFolders folders) {
        levels = folders.levels();
        settingsFile = new UserFile(in(folders.settings(), "settings.json"), "nephele-settings", 1);
        progressFile = new UserFile(in(folders.state(), "progress.json"), "nephele-progress", 1);
        qualityFile = new UserFile(in(folders.state(), "quality.json"), "nephele-quality", 1);
        settings = GameSettings.of(settingsFile.read(problems::add), reporter(settingsFile));
        progress = Progress.of(progressFile.read(problems::add), reporter(progressFile));
        quality = new QualityMemory(qualityFile.read(unusable -> {})); // it is learned again
        if (settingsFile.path() == null) {
            problems.add("no folder for settings is known (HOME is not set): nothing is kept");
        }
    }

    private static Path in(Path folder, String name) {
        return folder == null ? null : folder.resolve(name);
    }

    private Consumer<String> reporter(UserFile file) {
        return problem -> problems.add(file.path() + ": " + problem);
    }

    /** Returns the problems since the last call, each a line that names the file. */
    public List<String> takeProblems() {
        if (problems.isEmpty()) {
            return List.of();
        }
        List<String> taken = List.copyOf(problems);
        problems.clear();
        return taken;
    }

    /** Returns the folder of the player's own levels, which need not exist; {@code null} if there is no place for it. */
    public Path levels() {
        return levels;
    }

    /** Returns the current settings. */
    public GameSettings settings() {
        return settings;
    }

    /** Returns the current progress. */
    public Progress progress() {
        return progress;
    }

    /** Replaces and saves the settings; they hold even if they cannot be saved. */
    public void keep(GameSettings changed) {
        settings = changed;
        try {
            settingsFile.save(changed.entries());
        } catch (IOException unsaved) {
            problems.add(unsaved.getMessage());
        }
    }

    /** Replaces and saves the progress. */
    public void keep(Progress changed) {
        if (changed == progress) {
            return;
        }
        progress = changed;
        try {
            progressFile.save(changed.members());
        } catch (IOException unsaved) {
            problems.add(unsaved.getMessage());
        }
    }

    /** Returns what was learned of quality. */
    public QualityMemory quality() {
        return quality;
    }

    /** Replaces and saves what was learned of quality; if it cannot be saved, it is learned again the next time. */
    public void keep(QualityMemory changed) {
        quality = changed;
        try {
            qualityFile.save(changed.members());
        } catch (IOException unsaved) {
            return;
        }
    }
}
