package nephele.lab.trade;

import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import nephele.engine.math.Hash64;

/** The commit of the checkout in the working directory, and a description of the machine without host or user names. */
public final class Provenance {
    private Provenance() {}

    /** Returns the short hash, with a plus sign if tracked files differ from it; "unknown" without git or checkout. */
    public static String commit() {
        String hash = git("rev-parse", "--short=10", "HEAD");
        if (hash.isEmpty()) {
            return "unknown";
        }
        boolean changed = !git("status", "--porcelain", "--untracked-files=no", "--", ":!docs/proofs.md")
                .isEmpty();
        return changed ? hash + "+" : hash;
    }

    public static String machine() {
        return processor() + ", " + Runtime.getRuntime().availableProcessors() + " cores, "
                + System.getProperty("os.name") + " " + System.getProperty("os.arch") + ", Java "
                + System.getProperty("java.version");
    }

    private static String processor() {
        try (var lines = Files.lines(Path.of("/proc/cpuinfo"))) {
            return lines.filter(line -> line.startsWith("model name"))
                    .findFirst()
                    .map(line -> line.substring(line.indexOf(':') + 1).strip())
                    .orElse("processor unknown");
        } catch (IOException notLinux) {
            return "processor unknown";
        }
    }

    private static String git(String... arguments) {
        var words = new ArrayList<String>();
        words.add("git");
        words.addAll(List.of(arguments));
        try {
            var process = new ProcessBuilder(words)
                    .redirectError(ProcessBuilder.Redirect.DISCARD)
                    .start();
            var answer = new String(process.getInputStream().readAllBytes()).strip();
            return process.waitFor(10, TimeUnit.SECONDS) && process.exitValue() == 0 ? answer : "";
        } catch (IOException withoutGit) {
            return "";
        } catch (InterruptedException interrupted) {
            Thread.currentThread().interrupt();
            return "";
        }
    }

    /** Computed once, because the code of a running program does not change. */
    private static final class Running {
        private static final String KEY =
                codeHash(Arrays.stream(System.getProperty("java.class.path").split(File.pathSeparator))
                        .filter(entry -> !entry.isEmpty())
                        .map(Path::of)
                        .toList());
    }

    /** Returns a hash of everything on the class path: classes, shaders and libraries. */
    public static String codeHash() {
        return Running.KEY;
    }

    /**
     * Returns a hash of the relative names and the content of files, and of the files in folders. The folder's location
     * and modification times do not enter.
     *
     * @param classPath files and folders; a path that does not exist counts as empty
     */
    static String codeHash(List<Path> classPath) {
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
