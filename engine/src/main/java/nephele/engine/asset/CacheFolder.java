package nephele.engine.asset;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/**
 * A folder of reproducible files with a size limit: if a new file does not fit, the least recently used ones are
 * deleted. Files that do not match the pattern are never deleted.
 *
 * @param pattern glob of the files' names
 * @param mostBytes limit for all files together; the newest one is kept even if it is larger
 */
public record CacheFolder(Path folder, String pattern, long mostBytes) {
    /** Returns the user's own cache folder, which may not exist yet. */
    public static Path ofUser() {
        String cache = System.getenv("XDG_CACHE_HOME");
        Path base = cache == null || cache.isBlank()
                ? Path.of(System.getProperty("user.home", "."), ".cache")
                : Path.of(cache);
        return base.resolve("nephele");
    }

    /** Returns the bytes of a file and marks it as used now; empty if it does not exist or cannot be read. */
    public Optional<byte[]> find(String name) {
        Path file = folder.resolve(name);
        try {
            byte[] bytes = Files.readAllBytes(file);
            touch(file);
            return Optional.of(bytes);
        } catch (IOException e) {
            return Optional.empty();
        }
    }

    private static void touch(Path file) {
        try {
            Files.setLastModifiedTime(file, FileTime.fromMillis(System.currentTimeMillis()));
        } catch (IOException e) {
            // A read-only folder is never trimmed either.
            return;
        }
    }

    /** Writes a file atomically and deletes the least recently used ones above the limit. */
    public void store(String name, byte[] bytes) throws IOException {
        Files.createDirectories(folder);
        // Not createTempFile, whose files no other user could read.
        Path temporary = folder.resolve(String.format(Locale.ROOT, "%s-%x.tmp", name, System.nanoTime()));
        try {
            Files.write(temporary, bytes);
            Files.move(temporary, folder.resolve(name), StandardCopyOption.REPLACE_EXISTING);
        } finally {
            Files.deleteIfExists(temporary);
        }
        trim(folder.resolve(name));
    }

    private void trim(Path newest) throws IOException {
        Map<Path, BasicFileAttributes> files = new HashMap<>();
        long sum = 0;
        try (DirectoryStream<Path> all = Files.newDirectoryStream(folder, pattern)) {
            for (Path file : all) {
                BasicFileAttributes stored = Files.readAttributes(file, BasicFileAttributes.class);
                files.put(file, stored);
                sum += stored.size();
            }
        }
        List<Path> oldestFirst = new ArrayList<>(files.keySet());
        oldestFirst.sort(Comparator.comparing((Path file) -> files.get(file).lastModifiedTime())
                .thenComparing(Comparator.naturalOrder()));
        for (Path oldest : oldestFirst) {
            if (sum > mostBytes && !oldest.equals(newest)) {
                Files.deleteIfExists(oldest);
                sum -= files.get(oldest).size();
            }
        }
    }
}
