package nephele.editor.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.text.DecimalFormat;
import java.text.DecimalFormatSymbols;
import java.time.Instant;
import java.time.ZoneId;
import java.util.List;
import java.util.Locale;
import nephele.editor.save.Backups.Backup;
import nephele.editor.save.DocumentFile;
import nephele.editor.session.EditorSession;
import nephele.editor.text.EditorRefusal;
import nephele.editor.text.Words;
import nephele.engine.level.Level;
import nephele.engine.level.json.LevelFile;
import nephele.engine.level.json.LevelFormatException;

/** The previous versions of a session's file, the newest first. */
public final class BackupList {
    private static final double BYTES_PER_KB = 1000;

    private final EditorSession session;
    private final List<Backup> backups;
    private final Instant now;
    private final ZoneId zone;

    /** Lists the backups of the open file; an untitled level has none. */
    public BackupList(EditorSession session, Instant now, ZoneId zone) {
        this.session = session;
        this.now = now;
        this.zone = zone;
        backups =
                session.file().path().map(session.fileServices().backups()::of).orElse(List.of());
    }

    /** Returns a line for each version. */
    public List<FileRow> rows() {
        return backups.stream()
                .map(backup -> new FileRow(time(backup), size(backup.file()), Words.NONE))
                .toList();
    }

    private Words time(Backup backup) {
        return FileText.time(backup.replaced(), now, zone);
    }

    private static Words size(Path file) {
        try {
            double kilobytes = Files.size(file) / BYTES_PER_KB;
            return Words.of(
                    size(kilobytes, Locale.ENGLISH),
                    size(kilobytes, Locale.forLanguageTag("pt")),
                    size(kilobytes, Locale.forLanguageTag("pt")));
        } catch (IOException gone) {
            return Words.NONE;
        }
    }

    private static String size(double kilobytes, Locale locale) {
        return new DecimalFormat("0.0", DecimalFormatSymbols.getInstance(locale)).format(kilobytes) + " kB";
    }

    /** Returns the level of a line. */
    public Level level(int index) throws EditorRefusal {
        try {
            return session.background()
                    .get(() -> LevelFile.read(backups.get(index).file()));
        } catch (LevelFormatException broken) {
            throw new EditorRefusal(FileText.BAD_BACKUP.with(
                    broken.getMessage().lines().findFirst().orElse("")));
        }
    }

    /** Puts a version into the open document as one step that undo takes back. */
    public void restore(int index) throws EditorRefusal {
        Level level = level(index);
        session.document().edit(FileText.RESTORED.words(), now -> level);
        session.status(FileText.RESTORED_STATUS.with(time(backups.get(index))));
    }

    /** Opens a version as an untitled level with the same assets; what was open before is left. */
    public void openCopy(int index) throws EditorRefusal {
        Level level = level(index);
        session.open(DocumentFile.UNTITLED, level, session.assets());
        session.status(FileText.COPY_STATUS.with(time(backups.get(index))));
    }
}
