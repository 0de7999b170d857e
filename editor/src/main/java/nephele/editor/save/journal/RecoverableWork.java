package nephele.editor.save.journal;

import java.nio.file.Path;
import java.time.Instant;
import java.util.Optional;
import nephele.editor.save.DocumentFile;
import nephele.engine.level.Level;

/**
 * Unsaved work of an editor that has ended.
 *
 * @param journal the folder that holds it
 * @param file the document's file as that editor last opened or saved it
 * @param saved the level in that file then, or the one with which an untitled document began
 * @param level the level after the last edit
 * @param edits since it was opened or saved
 * @param lastLabel label of the last edit
 */
public record RecoverableWork(
        Path journal,
        String title,
        DocumentFile file,
        Level saved,
        Level level,
        Instant lastEdit,
        long edits,
        String lastLabel,
        Optional<Path> picture) {}
