package nephele.lab.trade;

import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import nephele.engine.math.BitHash;

/** Which code is running: what was measured with other code does not count. */
public final class CodeState {
    private CodeState() {}

    /** Read once: the code of a running program stays. */
    private static final class Running {
        private static final String KEY =
                of(Arrays.stream(System.getProperty("java.class.path").split(File.pathSeparator))
                        .filter(entry -> !entry.isEmpty())
                        .map(Path::of)
                        .toList());
    }

    /** Of everything on the class path: classes, shaders and libraries. */
    public static String key() {
        return Running.KEY;
    }

    /**
     * Of the content of files and of the files in folders, wherever these lie and whenever they were written.
     *
     * @param classPath what does not exist counts as empty
     */
    static String of(List<Path> classPath) {
        long hash = 0;
        for (Path entry : classPath) {
            try (Stream<Path> files = Files.exists(entry) ? Files.walk(entry) : Stream.empty()) {
                for (Path file : files.filter(Files::isRegularFile).sorted().toList()) {
                    String name = entry.relativize(file).toString();
                    hash = BitHash.join(hash, BitHash.of(name));
                    hash = BitHash.join(hash, BitHash.of(Files.readAllBytes(file)));
                }
            } catch (IOException unreadable) {
                throw new UncheckedIOException(unreadable);
            }
        }
        return Long.toHexString(hash);
    }
}
