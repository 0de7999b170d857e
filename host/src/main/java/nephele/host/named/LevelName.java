package nephele.host.named;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AtomicFile;
import nephele.engine.asset.FileName;
import nephele.engine.asset.LevelAssets;
import nephele.engine.asset.Picture;
import nephele.engine.asset.PictureDecoder;
import nephele.engine.asset.ResourceAssets;
import nephele.engine.level.json.LevelFile;
import nephele.engine.level.json.LevelFormatException;
import nephele.engine.rule.LevelRules;
import nephele.engine.sim.replay.Replay;
import nephele.host.terminal.CommandFailure;

/**
 * A level as named by a user: a file, or a level in the jar.
 *
 * @param typed the path as the user typed it
 */
public record LevelName(String typed) {
    /** Length of the replay of a level without a recorded walk, in ticks at its start. */
    private static final int STANDING_TICKS = 300;

    private static final int LARGEST_REPLAY_BYTES = 64 << 20;
    private static final int LARGEST_PICTURE_BYTES = 4 << 20;

    /**
     * Returns the file name without folder, number and extension as a title: "01-first-light.json" is "First light".
     */
    public String title() {
        String words = fileName()
                .replaceFirst("\\.(json|zip)$", "")
                .replaceFirst("^[0-9]+-", "")
                .replace('-', ' ');
        return words.isEmpty() ? fileName() : Character.toUpperCase(words.charAt(0)) + words.substring(1);
    }

    /**
     * Reads the level and checks it by every rule that reads no picture.
     *
     * @throws LevelFormatException with all errors found
     */
    public OpenedLevel open() throws LevelFormatException {
        return checked(new OpenedLevel(LevelFile.open(typed)));
    }

    /**
     * Reads a copy of the level in its place: with the assets beside the level, and by the level's name in messages. The
     * level itself need not exist.
     *
     * @param copy a level file anywhere
     * @throws LevelFormatException with all errors found
     */
    public OpenedLevel openCopy(Path copy) throws LevelFormatException {
        var assets = LevelAssets.beside(Path.of(typed));
        return checked(new OpenedLevel(new LevelFile.Opened(typed, LevelFile.read(copy), assets, Optional.empty())));
    }

    private static OpenedLevel checked(OpenedLevel opened) {
        var errors = LevelRules.errorsBeforeUse(
                opened.level(), opened.assets(), () -> opened.placed().statics());
        if (!errors.isEmpty()) {
            throw new LevelFormatException(opened.file(), errors);
        }
        return opened;
    }

    /**
     * Returns the level's recorded walk; that of {@code d/x.json} is {@code d/replays/x.json}. Without one, it stands
     * still.
     */
    public Replay recordedWalk() {
        Path beside = solutionFile();
        if (Files.isRegularFile(beside)) {
            return replay(beside.toString());
        }
        return Files.exists(Path.of(typed)) ? standing() : walkInJar().orElseGet(this::standing);
    }

    /** Returns the file of the level's recorded walk, which need not exist. */
    public Path solutionFile() {
        return Path.of(typed).toAbsolutePath().resolveSibling("replays").resolve(fileName());
    }

    /**
     * Reads a replay file named by a user.
     *
     * @throws CommandFailure if it is unreadable, malformed or larger than 64 MiB
     */
    public static Replay replay(String file) {
        if (FileName.objection(file) != null) {
            throw CommandFailure.input(FileName.printable(file) + ": " + FileName.objection(file));
        }
        try {
            byte[] bytes = AtomicFile.read(Path.of(file), LARGEST_REPLAY_BYTES);
            if (bytes.length > LARGEST_REPLAY_BYTES) {
                throw CommandFailure.input(file + ": is larger than " + (LARGEST_REPLAY_BYTES >> 20) + " MiB");
            }
            return Replay.read(file, bytes);
        } catch (IOException | IllegalArgumentException unreadable) {
            throw CommandFailure.input(file + ": cannot be read: name a replay file");
        }
    }

    /**
     * Returns the level's picture for lists; that of {@code d/x.json} is {@code d/pictures/x.png}. Empty if there is none
     * that can be read.
     */
    public Optional<Picture> picture() {
        String name = fileName().replaceFirst("\\.(json|zip)$", ".png");
        Path beside = Path.of(typed).toAbsolutePath().resolveSibling("pictures").resolve(name);
        var jar = new ResourceAssets(LevelAssets.JAR_LEVELS);
        String resource = besideInJar("pictures/" + name);
        try {
            if (Files.isRegularFile(beside)) {
                return Optional.of(PictureDecoder.decode(name, AtomicFile.read(beside, LARGEST_PICTURE_BYTES)));
            }
            return !Files.exists(Path.of(typed)) && jar.exists(resource)
                    ? Optional.of(PictureDecoder.decode(name, jar.bytes(resource)))
                    : Optional.empty();
        } catch (IOException | AssetException unreadable) {
            return Optional.empty();
        }
    }

    /**
     * Returns the name under which progress in the level is kept: the file's, but of a level with an absolute path the
     * path, so that a level of the same name elsewhere is another one.
     */
    public String key() {
        Path path = Path.of(typed);
        return path.isAbsolute() ? path.normalize().toString() : fileName();
    }

    /** Returns the last part of the path. */
    public String fileName() {
        return typed.substring(Math.max(typed.lastIndexOf('/'), typed.lastIndexOf('\\')) + 1);
    }

    private Replay standing() {
        return Replay.standing(fileName(), STANDING_TICKS);
    }

    /** Returns the path in the jar of a file in the level's folder. */
    private String besideInJar(String file) {
        String inLevels = typed.replace('\\', '/').replaceFirst("^(\\./)?levels/", "");
        return inLevels.substring(0, inLevels.lastIndexOf('/') + 1) + file;
    }

    private Optional<Replay> walkInJar() {
        String resource = besideInJar("replays/" + fileName());
        var jar = new ResourceAssets(LevelAssets.JAR_LEVELS);
        return jar.exists(resource)
                ? Optional.of(Replay.read("levels/" + resource, jar.bytes(resource)))
                : Optional.empty();
    }
}
