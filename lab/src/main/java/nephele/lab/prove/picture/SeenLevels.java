package nephele.lab.prove.picture;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import nephele.engine.named.LevelCatalogue;

/** The levels of a checkout that are compared in pictures. */
final class SeenLevels {
    private SeenLevels() {}

    /**
     * Returns the files of every level and every sample except those with billboards or impostors: the tracer turns
     * billboards to each ray, the picture to the eye of each view, and traces the meshes of impostors, so that their edges
     * differ by more than a pixel.
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
                    .filter(SeenLevels::isWithoutPictures)
                    .map(Path::toString)
                    .sorted()
                    .toList();
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
    }

    private static boolean isWithoutPictures(Path file) {
        try {
            String text = Files.readString(file);
            return !text.contains("\"billboards\": [") && !text.contains("\"impostor\": true");
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
    }
}
