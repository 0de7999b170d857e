package nephele.workshop.prove.picture;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import nephele.engine.level.Billboards;
import nephele.engine.level.Billboards.Facing;
import nephele.engine.level.Level;
import nephele.host.named.LevelCatalogue;

/** The levels of a checkout that are compared in pictures. */
final class SeenLevels {
    private SeenLevels() {}

    /**
     * Returns the files of every level and every sample except those with impostors: the tracer traces their meshes, whose
     * edges differ by more than a pixel.
     */
    static List<String> all() {
        List<String> files = new ArrayList<>(in(Path.of("levels")));
        files.addAll(in(Path.of("levels", "samples")));
        return List.copyOf(files);
    }

    /** Returns an empty list outside of a checkout. */
    private static List<String> in(Path folder) {
        if (!Files.isDirectory(folder)) {
            return List.of();
        }
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(LevelCatalogue::isLevel)
                    .filter(SeenLevels::isWithoutImpostors)
                    .map(Path::toString)
                    .sorted()
                    .toList();
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
    }

    /**
     * Returns a level with those billboards alone that stand still, without wind. The tracer turns others to each ray, the
     * picture to the eye of each view, so that their edges differ by more than a pixel; blended ones are not traced, and
     * neither is the sphere of an observer.
     */
    static Level compared(Level level) {
        return level.withObserver(null)
                .withBillboards(level.billboards().stream()
                        .filter(group -> group.facing() == Facing.CROSSED && !group.blended())
                        .map(Billboards::withoutWind)
                        .toList());
    }

    private static boolean isWithoutImpostors(Path file) {
        try {
            return !Files.readString(file).contains("\"impostor\": true");
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
    }
}
