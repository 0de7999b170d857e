package nephele.editor.save;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.time.InstantSource;
import java.time.ZoneOffset;
import java.time.format.DateTimeFormatter;
import java.time.format.DateTimeParseException;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import nephele.editor.text.Words;
import nephele.engine.asset.AtomicFile;

/**
 * The previous versions of saved levels: up to 50 of each file, named by the time at which they were replaced. They lie
 * in the user's state folder, not beside the level, so that they survive the deletion of the level's folder.
 */
public final class Backups {
    /** The greatest number of versions that are kept of a file. */
    public static final int MOST = 50;

    private static final String ENDING = ".json";

    /** Sorts as text like time, and holds no character that Windows forbids. */
    private static final DateTimeFormatter NAME = DateTimeFormatter.ofPattern(
                    "uuuu-MM-dd'T'HH-mm-ss.SSS'Z'", Locale.ROOT)
            .withZone(ZoneOffset.UTC);

    /** A previous version of a level. */
    public record Backup(Path file, Instant replaced) {}

    private final Path folder;
    private final InstantSource clock;

    /** @param folder holds a folder for each file that was saved */
    public Backups(Path folder, InstantSource clock) {
        this.folder = folder;
        this.clock = clock;
    }

    /**
     * Copies the present version of a file, if there is one and it is not the newest backup, and deletes the oldest
     * backups.
     *
     * @return a notice if that failed
     */
    Optional<Words> keep(Path file) {
        if (!Files.isRegularFile(file)) {
            return Optional.empty();
        }
        try {
            return keep(file, Files.readAllBytes(file));
        } catch (IOException problem) {
            return Optional.of(SaveText.NO_BACKUP.with(folderOf(file), AtomicFile.reason(problem)));
        }
    }

    /**
     * Keeps a version of a file that may never have been in it, such as work that another version replaces, unless it is
     * the newest backup.
     *
     * @return a notice if that failed
     */
    public Optional<Words> keep(Path file, byte[] content) {
        Path own = folderOf(file);
        try {
            List<Backup> kept = of(file);
            if (kept.isEmpty() || !Arrays.equals(Files.readAllBytes(kept.get(0).file()), content)) {
                AtomicFile.write(fresh(own, kept), content, file);
                prune(of(file));
            }
            return Optional.empty();
        } catch (IOException problem) {
            return Optional.of(SaveText.NO_BACKUP.with(own, AtomicFile.reason(problem)));
        }
    }

    /** Returns the backups of a file, the newest first. */
    public List<Backup> of(Path file) {
        Path own = folderOf(file);
        if (!Files.isDirectory(own)) {
            return List.of();
        }
        try (var names = Files.list(own)) {
            return names.map(Backups::backup)
                    .flatMap(Optional::stream)
                    .sorted(Comparator.comparing(Backup::replaced).reversed())
                    .toList();
        } catch (IOException unreadable) {
            return List.of();
        }
    }

    /** Returns the folder of a file's backups, named after the file and its path. */
    private Path folderOf(Path file) {
        Path absolute = file.toAbsolutePath().normalize();
        String hash = ContentHash.of(absolute.toString().getBytes(StandardCharsets.UTF_8));
        return folder.resolve(absolute.getFileName() + "-" + hash.substring(0, 16));
    }

    /** Returns a name later than all others, even if the clock was set back. */
    private Path fresh(Path own, List<Backup> kept) {
        Instant now = Instant.ofEpochMilli(clock.millis());
        if (!kept.isEmpty() && !now.isAfter(kept.get(0).replaced())) {
            now = kept.get(0).replaced().plusMillis(1);
        }
        return own.resolve(NAME.format(now) + ENDING);
    }

    private static void prune(List<Backup> kept) throws IOException {
        for (int i = MOST; i < kept.size(); i++) {
            Files.deleteIfExists(kept.get(i).file());
        }
    }

    private static Optional<Backup> backup(Path file) {
        String name = file.getFileName().toString();
        if (!name.endsWith(ENDING)) {
            return Optional.empty();
        }
        try {
            String time = name.substring(0, name.length() - ENDING.length());
            return Optional.of(new Backup(file, NAME.parse(time, Instant::from)));
        } catch (DateTimeParseException notOurs) {
            return Optional.empty();
        }
    }
}
