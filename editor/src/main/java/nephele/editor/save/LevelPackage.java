package nephele.editor.save;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.time.LocalDateTime;
import java.util.Comparator;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import nephele.editor.text.EditorRefusal;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.AssetId;
import nephele.engine.asset.AssetSource;
import nephele.engine.asset.AtomicFile;
import nephele.engine.level.Level;
import nephele.engine.level.json.FileOperations;
import nephele.engine.level.json.LevelJson;
import nephele.engine.level.json.PackageContent;

/**
 * A level with all files that it names, as one .zip: the level is the only .json at the top, the others have their ids as
 * names. Files of the jar are included, so that the package looks the same in every version of the game.
 */
public final class LevelPackage {
    /** Fixed, so that equal levels give equal bytes. */
    private static final LocalDateTime ENTRY_TIME = LocalDateTime.of(1980, 1, 1, 0, 0);

    private LevelPackage() {}

    /**
     * Writes a package.
     *
     * @param levelName file name of the level in it, such as {@code courtyard.json}
     * @throws EditorRefusal if a file is missing or the package cannot be written; an older package is then unchanged
     */
    public static void export(Path zip, String levelName, Level level, AssetSource assets) throws EditorRefusal {
        Map<String, byte[]> entries = new TreeMap<>();
        for (String id : NamedAssets.of(level, assets)) {
            try {
                entries.put(id, assets.bytes(id));
            } catch (AssetException problem) {
                throw new EditorRefusal(SaveText.PACKAGE_ASSET.with(zip, problem.getMessage()), problem);
            }
        }
        entries.put(entryName(levelName), LevelJson.write(level).getBytes(StandardCharsets.UTF_8));
        try {
            write(zip, entries);
        } catch (IOException problem) {
            throw new EditorRefusal(DocumentSaver.message(zip, problem), problem);
        }
    }

    /** Returns a name that can be opened again, whatever the level's file is called. */
    private static String entryName(String levelName) {
        boolean fits = AssetId.rejectionReason(levelName) == null && !levelName.contains("/");
        return fits && levelName.endsWith(".json") ? levelName : "level.json";
    }

    private static void write(Path zip, Map<String, byte[]> entries) throws IOException {
        Path target = AtomicFile.target(zip);
        Path fresh = target.resolveSibling(target.getFileName() + ".tmp");
        try {
            try (var out = new ZipOutputStream(Files.newOutputStream(fresh))) {
                for (var entry : entries.entrySet()) {
                    ZipEntry written = new ZipEntry(entry.getKey());
                    written.setTimeLocal(ENTRY_TIME);
                    out.putNextEntry(written);
                    out.write(entry.getValue());
                    out.closeEntry();
                }
            }
            AtomicFile.adopt(fresh, target);
            FileOperations.REAL.force(fresh);
            Files.move(fresh, target, StandardCopyOption.ATOMIC_MOVE);
        } finally {
            Files.deleteIfExists(fresh);
        }
    }

    /**
     * Unpacks a package into a folder, which is made; entries that the level does not need are left out.
     *
     * @param folder missing or empty
     * @return the level's file
     * @throws EditorRefusal if it is no package, or has an entry that is unsafe; the folder is then as before
     */
    public static Path extract(Path zip, Path folder) throws EditorRefusal {
        Path target = folder.toAbsolutePath().normalize();
        PackageContent content = content(zip);
        try {
            if (Files.exists(target) && !isEmpty(target)) {
                throw new EditorRefusal(SaveText.PACKAGE_TARGET.with(folder));
            }
            Files.createDirectories(target.getParent());
            Path fresh = Files.createTempDirectory(target.getParent(), ".nephele-package");
            try {
                unpack(content, fresh);
                Files.deleteIfExists(target);
                Files.move(fresh, target, StandardCopyOption.ATOMIC_MOVE);
            } finally {
                delete(fresh);
            }
            return target.resolve(content.levelName());
        } catch (IOException problem) {
            throw new EditorRefusal(DocumentSaver.message(folder, problem), problem);
        }
    }

    private static PackageContent content(Path zip) throws EditorRefusal {
        try {
            return PackageContent.read(zip);
        } catch (PackageContent.Refused refused) {
            String reason = refused.getMessage();
            throw new EditorRefusal(
                    refused.entry()
                            .map(entry -> SaveText.PACKAGE_ENTRY.with(zip, entry, reason))
                            .orElseGet(() -> SaveText.PACKAGE_UNREADABLE.with(zip, reason)),
                    refused);
        }
    }

    private static void unpack(PackageContent content, Path folder) throws IOException {
        AtomicFile.write(folder.resolve(content.levelName()), content.assets().bytes(content.levelName()));
        Set<String> needed = NamedAssets.of(content.level(), content.assets());
        for (String id : needed) {
            if (content.assets().exists(id)) {
                AtomicFile.write(folder.resolve(id), content.assets().bytes(id));
            }
        }
    }

    private static boolean isEmpty(Path folder) throws IOException {
        if (!Files.isDirectory(folder)) {
            return false;
        }
        try (Stream<Path> entries = Files.list(folder)) {
            return entries.findAny().isEmpty();
        }
    }

    private static void delete(Path folder) throws IOException {
        if (!Files.exists(folder)) {
            return;
        }
        try (Stream<Path> all = Files.walk(folder)) {
            for (Path each : all.sorted(Comparator.reverseOrder()).toList()) {
                Files.delete(each);
            }
        }
    }
}
