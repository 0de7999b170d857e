package nephele.editor.save.journal;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.InstantSource;
import java.util.List;

/** The journals of an editor as a crash at this moment would leave them: a copy, because their owner lives. */
public final class CrashedEditor {
    private CrashedEditor() {}

    /** Returns a copy of a folder of journals, as the next process sees it. */
    public static JournalFolder copy(Path journals, Path target) throws IOException {
        List<Path> all;
        try (var walk = Files.exists(journals) ? Files.walk(journals) : java.util.stream.Stream.<Path>empty()) {
            all = walk.toList();
        }
        Files.createDirectories(target);
        for (Path each : all) {
            Path to = target.resolve(journals.relativize(each).toString());
            if (Files.isDirectory(each)) {
                Files.createDirectories(to);
            } else if (each.getFileName().toString().equals("lock")) {
                // Reading it would end the owner's lock: POSIX locks end when any channel to the file is closed.
                Files.createFile(to);
            } else {
                Files.copy(each, to);
            }
        }
        return new JournalFolder(target, InstantSource.system());
    }
}
