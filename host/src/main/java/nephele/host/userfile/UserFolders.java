package nephele.host.userfile;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/**
 * The folders of a user's files: on Linux those of the XDG Base Directory Specification (freedesktop.org, 2021), on
 * macOS and Windows the folder for application data.
 *
 * @param settings folder of the settings; {@code null} if the environment names none
 * @param state folder of what is kept between runs: progress, the editor's journals and backups; {@code null} if the environment names none
 * @param data folder of what the user makes, such as levels; {@code null} if the environment names none
 */
public record UserFolders(Path settings, Path state, Path data) {
    private static final String NAME = "nephele";

    /**
     * Returns the folders for a system and its environment.
     *
     * @param system the value of {@code os.name}
     */
    public static UserFolders of(String system, Map<String, String> environment) {
        String name = system.toLowerCase(Locale.ROOT);
        Optional<Path> home = absolute(environment.get("HOME"));
        if (name.contains("windows")) {
            Path both = absolute(environment.get("APPDATA"))
                    .map(folder -> folder.resolve(NAME))
                    .orElse(null);
            return new UserFolders(both, both, both);
        }
        if (name.contains("mac")) {
            Path both = home.map(folder -> folder.resolve("Library")
                            .resolve("Application Support")
                            .resolve(NAME))
                    .orElse(null);
            return new UserFolders(both, both, both);
        }
        return new UserFolders(
                xdg(environment.get("XDG_CONFIG_HOME"), home, ".config"),
                xdg(environment.get("XDG_STATE_HOME"), home, ".local/state"),
                xdg(environment.get("XDG_DATA_HOME"), home, ".local/share"));
    }

    /** Returns the folders of this process. */
    public static UserFolders ofThisUser() {
        return of(System.getProperty("os.name"), System.getenv());
    }

    /** Returns the folder of the user's own levels; {@code null} if the environment names none. */
    public Path levels() {
        return data == null ? null : data.resolve("levels");
    }

    private static Path xdg(String named, Optional<Path> home, String belowHome) {
        return absolute(named)
                .or(() -> home.map(folder -> folder.resolve(belowHome)))
                .map(folder -> folder.resolve(NAME))
                .orElse(null);
    }

    /** Returns an absolute path; the specification ignores relative ones. */
    private static Optional<Path> absolute(String text) {
        try {
            return text == null || text.isEmpty()
                    ? Optional.empty()
                    : Optional.of(Path.of(text)).filter(Path::isAbsolute);
        } catch (InvalidPathException noPath) {
            return Optional.empty();
        }
    }
}
