package nephele.engine.named;

import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.jar.JarFile;
import java.util.stream.Stream;
import nephele.engine.terminal.CommandFailure;

/** Finds the game's levels: in {@code levels/} of the working directory first, then in the jar. */
public final class LevelCatalogue {
    private static final Path CHECKOUT = Path.of("levels");
    private static final String NUMBERED = "[0-9]{2}-.*\\.json";

    private LevelCatalogue() {}

    /**
     * Returns the level that a game starts with by default.
     *
     * @throws CommandFailure if there is none
     */
    public static LevelName first() {
        var all = numbered();
        if (all.isEmpty()) {
            throw CommandFailure.environment(
                    "no levels/01-*.json in the working directory or in the jar; name a level: nephele play LEVEL");
        }
        return all.get(0);
    }

    /** Returns the game's levels in order; empty if there are none. */
    public static List<LevelName> numbered() {
        var inCheckout = inCheckout();
        return inCheckout.isEmpty() ? inJar() : inCheckout;
    }

    private static List<LevelName> inCheckout() {
        if (!Files.isDirectory(CHECKOUT)) {
            return List.of();
        }
        try (Stream<Path> files = Files.list(CHECKOUT)) {
            return files.filter(file -> file.getFileName().toString().matches(NUMBERED))
                    .sorted()
                    .map(file -> new LevelName(file.toString()))
                    .toList();
        } catch (IOException unreadable) {
            return List.of();
        }
    }

    private static List<LevelName> inJar() {
        try {
            var code = LevelCatalogue.class.getProtectionDomain().getCodeSource();
            var archive = code == null ? null : Path.of(code.getLocation().toURI());
            if (archive == null || !Files.isRegularFile(archive)) {
                return List.of();
            }
            try (var jar = new JarFile(archive.toFile())) {
                return jar.stream()
                        .map(entry -> entry.getName().replaceFirst("^levels/", ""))
                        .filter(name -> name.matches(NUMBERED))
                        .sorted()
                        .map(name -> new LevelName("levels/" + name))
                        .toList();
            }
        } catch (IOException | URISyntaxException unreadable) {
            return List.of();
        }
    }
}
