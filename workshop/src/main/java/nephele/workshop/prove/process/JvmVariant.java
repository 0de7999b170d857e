package nephele.workshop.prove.process;

import java.io.IOException;
import java.io.Reader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Properties;
import java.util.TreeMap;
import java.util.stream.Stream;

/** A Java installation and the flags of its process, which select how it compiles, or a language and a time zone. */
public record JvmVariant(String name, Path java, List<String> flags) {
    private static final int OLDEST = 17;

    private static final List<List<String>> FLAGS = List.of(
            List.of(),
            List.of("-Xint"),
            List.of("-XX:TieredStopAtLevel=1"),
            List.of("-XX:-TieredCompilation", "-XX:+UseSerialGC"),
            List.of("-Duser.language=tr", "-Duser.country=TR", "-Duser.timezone=Asia/Kathmandu"));

    /**
     * Returns variants with all flags on the running Java first, then on one installation of each other version in the
     * same folder.
     */
    public static List<JvmVariant> all() {
        List<JvmVariant> variants = new ArrayList<>();
        for (Path home : homes()) {
            for (List<String> flags : FLAGS) {
                String how = flags.isEmpty() ? "default" : String.join(" ", flags);
                variants.add(new JvmVariant("Java " + version(home) + ", " + how, home.resolve("bin/java"), flags));
            }
        }
        return variants;
    }

    private static List<Path> homes() {
        Path running = Path.of(System.getProperty("java.home")).toAbsolutePath();
        var byVersion = new TreeMap<Integer, Path>();
        if (running.getParent() != null && Files.isDirectory(running.getParent())) {
            try (Stream<Path> beside = Files.list(running.getParent())) {
                beside.sorted().forEach(home -> {
                    if (version(home) >= OLDEST && Files.isExecutable(home.resolve("bin/java"))) {
                        byVersion.putIfAbsent(version(home), home);
                    }
                });
            } catch (IOException unreadable) {
                byVersion.clear();
            }
        }
        List<Path> homes = new ArrayList<>(List.of(running));
        byVersion.remove(version(running));
        homes.addAll(byVersion.values());
        return homes;
    }

    /** Returns the feature version from the installation's release file, or 0 if it has none. */
    private static int version(Path home) {
        var release = new Properties();
        try (Reader reader = Files.newBufferedReader(home.resolve("release"))) {
            release.load(reader);
        } catch (IOException | IllegalArgumentException none) {
            return 0;
        }
        String digits = release.getProperty("JAVA_VERSION", "0").replaceAll("^\"?(\\d+).*$", "$1");
        return digits.matches("\\d{1,4}") ? Integer.parseInt(digits) : 0;
    }

    @Override
    public String toString() {
        return name;
    }
}
