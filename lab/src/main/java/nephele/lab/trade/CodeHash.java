package nephele.lab.trade;

import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import nephele.engine.math.Hash64;

/** A hash of the running code. Measurements of other code are discarded. */
public final class CodeHash {
    private CodeHash() {}

    /** Computed once, because the code of a running program does not change. */
    private static final class Running {
        private static final String KEY =
                of(Arrays.stream(System.getProperty("java.class.path").split(File.pathSeparator))
                        .filter(entry -> !entry.isEmpty())
                        .map(Path::of)
                        .toList());
    }

    /** Returns a hash of everything on the class path: classes, shaders and libraries. */
    public static String key() {
        return Running.KEY;
    }

    /**
     * Returns a hash of the relative names and the content of files, and of the files in folders. The folder's location
     * and modification times do not enter.
     *
     * @param classPath files and folders; a path that does not exist counts as empty
     */
    static String of(List<Path> classPath) {
        long hash = 0;
        for (Path entry : classPath) {
            try (Stream<Path> files = Files.exists(entry) ? Files.walk(entry) : Stream.empty()) {
                for (Path file : files.filter(Files::isRegularFile).sorted().toList()) {
                    String name = entry.relativize(file).toString();
                    hash = Hash64.combine(hash, Hash64.of(name));
                    hash = Hash64.combine(hash, Hash64.of(Files.readAllBytes(file)));
                }
            } catch (IOException unreadable) {
                throw new UncheckedIOException(unreadable);
            }
        }
        return Long.toHexString(hash);
    }
}
