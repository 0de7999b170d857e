package nephele.engine.level.json;

/** Thrown for a level that was not saved; the file on disk is unchanged. */
public final class LevelSaveException extends RuntimeException {
    private static final long serialVersionUID = 1;

    public LevelSaveException(String file, String reason, Throwable cause) {
        super(file + ": cannot be saved: " + reason + "; the version on disk is untouched", cause);
    }
}
