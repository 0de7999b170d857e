package nephele.editor.save;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.attribute.DosFileAttributes;
import java.nio.file.attribute.PosixFileAttributes;
import java.nio.file.attribute.PosixFilePermission;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import nephele.editor.text.Words;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.AtomicFile;
import nephele.engine.asset.LevelAssets;
import nephele.engine.level.Level;
import nephele.engine.level.json.FileOperations;
import nephele.engine.level.json.LevelFile;
import nephele.engine.level.json.LevelFormatException;
import nephele.engine.level.json.LevelJson;
import nephele.engine.level.json.LevelSaveException;

/** Saves documents atomically, with backups, and never over a version that its author has not seen. */
public final class DocumentSaver {
    private static final Set<PosixFilePermission> WRITE =
            Set.of(PosixFilePermission.OWNER_WRITE, PosixFilePermission.GROUP_WRITE, PosixFilePermission.OTHERS_WRITE);

    private final Backups backups;
    private final FileOperations files;

    public DocumentSaver(Backups backups) {
        this(backups, FileOperations.REAL);
    }

    /** @param files lets tests fail each operation of a save */
    public DocumentSaver(Backups backups, FileOperations files) {
        this.backups = backups;
        this.files = files;
    }

    /**
     * Saves a document to its own file, unless that is no longer as it was opened or saved.
     *
     * @param file not untitled
     */
    public SaveResult save(DocumentFile file, Level level) {
        return save(file, () -> saveAs(file.path().orElseThrow(), level));
    }

    /**
     * Saves a document as {@link #save(DocumentFile, Level)}, with the files that it needs.
     *
     * @param from the files that the level can name now
     */
    public SaveResult save(DocumentFile file, Level level, AssetSource from) {
        return save(file, () -> saveAs(file.path().orElseThrow(), level, from));
    }

    private static SaveResult save(DocumentFile file, Supplier<SaveResult> writing) {
        Path path = file.path().orElseThrow(() -> new IllegalArgumentException("an untitled document has no file yet"));
        Optional<Words> obstacle = obstacle(path);
        if (obstacle.isPresent()) {
            return new SaveResult.Failed(obstacle.get());
        }
        return switch (file.outside()) {
            case SAME -> writing.get();
            case CHANGED -> new SaveResult.ChangedOutside(SaveText.CHANGED_OUTSIDE.with(path));
            case DELETED -> new SaveResult.ChangedOutside(SaveText.DELETED_OUTSIDE.with(path));
        };
    }

    /** Saves a level to a file that the user has chosen, and replaces what is there; that becomes a backup. */
    public SaveResult saveAs(Path path, Level level) {
        Optional<Words> obstacle = obstacle(path);
        if (obstacle.isPresent()) {
            return new SaveResult.Failed(obstacle.get());
        }
        Optional<Words> notice = backups.keep(path);
        try {
            byte[] content = LevelJson.write(level).getBytes(StandardCharsets.UTF_8);
            LevelFile.save(path, level, files);
            return new SaveResult.Saved(
                    DocumentFile.saved(path, content), notice.stream().toList());
        } catch (LevelFormatException noLevel) {
            String first = noLevel.getMessage().lines().findFirst().orElse("");
            return new SaveResult.Failed(SaveText.NO_LEVEL_FILE.with(first));
        } catch (LevelSaveException problem) {
            return new SaveResult.Failed(
                    problem.getCause() instanceof IOException cause
                            ? message(path, cause)
                            : SaveText.NOT_SAVED.with(path, problem.getMessage()));
        }
    }

    /**
     * Saves a level as {@link #saveAs(Path, Level)}, with the files that it needs.
     *
     * @param from the files of the level where it is now
     */
    public SaveResult saveAs(Path path, Level level, AssetSource from) {
        Optional<Words> obstacle = obstacle(path).or(() -> copy(level, from, path));
        return obstacle.isPresent() ? new SaveResult.Failed(obstacle.get()) : saveAs(path, level);
    }

    /** Returns the reason why a file cannot be saved, if it can be seen before. */
    private static Optional<Words> obstacle(Path path) {
        Path folder = path.toAbsolutePath().getParent();
        if (Files.isDirectory(path)) {
            return Optional.of(SaveText.IS_FOLDER.with(path));
        }
        if (folder == null || !Files.isDirectory(folder)) {
            return Optional.of(SaveText.FOLDER_MISSING.with(folder));
        }
        return isReadOnly(path) ? Optional.of(SaveText.READ_ONLY.with(path)) : Optional.empty();
    }

    /**
     * Asks the file's permissions, too: renaming over a read-only file succeeds where its folder is writable, and an
     * administrator may write everything.
     */
    private static boolean isReadOnly(Path path) {
        if (!Files.exists(path)) {
            return false;
        }
        try {
            Set<String> views = path.getFileSystem().supportedFileAttributeViews();
            boolean denied = views.contains("posix")
                    ? Files.readAttributes(path, PosixFileAttributes.class).permissions().stream()
                            .noneMatch(WRITE::contains)
                    : views.contains("dos")
                            && Files.readAttributes(path, DosFileAttributes.class)
                                    .isReadOnly();
            return denied || !Files.isWritable(path);
        } catch (IOException | UnsupportedOperationException unknown) {
            return !Files.isWritable(path);
        }
    }

    /** Returns the message of a failed write. */
    static Words message(Path path, IOException problem) {
        if (AtomicFile.isDiskFull(problem)) {
            return SaveText.DISK_FULL.with(path);
        }
        if (problem instanceof AccessDeniedException) {
            return SaveText.ACCESS_DENIED.with(path);
        }
        if (problem instanceof NoSuchFileException) {
            return SaveText.FOLDER_MISSING.with(path.toAbsolutePath().getParent());
        }
        return SaveText.NOT_SAVED.with(path, AtomicFile.reason(problem));
    }

    /**
     * Copies what a level at its new place would not find, or find otherwise.
     *
     * @param from the files of the level where it is now
     * @return why the level cannot be saved there; a file that cannot be read is left to the level's check
     */
    private static Optional<Words> copy(Level level, AssetSource from, Path levelFile) {
        LevelAssets there = LevelAssets.beside(levelFile);
        List<String> copies = new ArrayList<>();
        for (String id : NamedAssets.of(level, from)) {
            if (!from.exists(id) || isSame(id, from, there)) {
                continue;
            }
            Path place = levelFile.resolveSibling(id);
            if (Files.exists(place)) {
                return Optional.of(SaveText.ASSET_TAKEN.with(place));
            }
            copies.add(id);
        }
        for (String id : copies) {
            Path place = levelFile.resolveSibling(id);
            try {
                Files.createDirectories(place.toAbsolutePath().getParent());
                AtomicFile.write(place, from.bytes(id));
            } catch (IOException problem) {
                return Optional.of(message(place, problem));
            } catch (AssetException unreadable) {
                continue;
            }
        }
        return Optional.empty();
    }

    private static boolean isSame(String id, AssetSource from, AssetSource there) {
        try {
            return there.exists(id) && Arrays.equals(there.bytes(id), from.bytes(id));
        } catch (AssetException unreadable) {
            return false;
        }
    }
}
