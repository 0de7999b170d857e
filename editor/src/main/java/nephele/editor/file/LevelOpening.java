package nephele.editor.file;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import nephele.editor.save.DocumentFile;
import nephele.editor.save.LevelPackage;
import nephele.editor.session.EditorSession;
import nephele.editor.text.EditorRefusal;
import nephele.editor.text.Words;
import nephele.engine.level.json.LevelFormatException;

/** Opens levels from files and packages. */
public final class LevelOpening {
    private LevelOpening() {}

    /** Opens a level, or unpacks a package into a new folder beside it and opens its level, in place of the open one. */
    public static void open(EditorSession session, String typed) throws EditorRefusal {
        boolean isPackage = typed.toLowerCase(Locale.ROOT).endsWith(".zip");
        try {
            Path unpacked = isPackage ? session.background().get(() -> unpacked(Path.of(typed))) : null;
            DocumentFile.Opened opened =
                    session.background().get(() -> DocumentFile.open(isPackage ? unpacked.toString() : typed));
            session.open(opened.file(), opened.level(), opened.assets());
            session.panes(panes -> panes.opened(opened.level()));
            Optional<Words> reported = isPackage
                    ? Optional.of(FileText.UNPACKED.with(unpacked.getParent()))
                    : opened.notice().map(Words::same);
            reported.ifPresent(session::status);
        } catch (LevelFormatException noLevel) {
            throw new EditorRefusal(Words.same(noLevel.getMessage()));
        }
    }

    /** Returns the level's file of a package that was unpacked beside it. */
    private static Path unpacked(Path zip) throws EditorRefusal {
        Path absolute = zip.toAbsolutePath().normalize();
        String name = absolute.getFileName().toString();
        return LevelPackage.extract(zip, fresh(absolute.resolveSibling(name.substring(0, name.length() - 4)), ""));
    }

    /** Returns a path that is free, with a number if need be: {@code room.json}, {@code room-2.json}. */
    static Path fresh(Path wish, String ending) {
        Path free = Path.of(wish + ending);
        for (int number = 2; !isFree(free); number++) {
            free = Path.of(wish + "-" + number + ending);
        }
        return free;
    }

    private static boolean isFree(Path path) {
        if (!Files.isDirectory(path)) {
            return !Files.exists(path);
        }
        try (DirectoryStream<Path> inside = Files.newDirectoryStream(path)) {
            return !inside.iterator().hasNext();
        } catch (IOException unreadable) {
            return false;
        }
    }
}
