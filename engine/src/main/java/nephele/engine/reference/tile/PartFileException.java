package nephele.engine.reference.tile;

import java.nio.file.Path;

/** A part file cannot be used. The message tells the user which one, what is wrong and what to do. */
public final class PartFileException extends RuntimeException {
    private static final long serialVersionUID = 1;

    /** @param problem in words that follow the file's name and a colon */
    public PartFileException(Path file, String problem) {
        super(file + ": " + problem);
    }
}
