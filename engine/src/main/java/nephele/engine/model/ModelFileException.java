package nephele.engine.model;

import nephele.engine.asset.MessageText;

/** An unusable mesh, curve or scene file: file, line, reason, and remedy for its author. */
public final class ModelFileException extends RuntimeException {
    private static final long serialVersionUID = 1;

    private final String file;
    private final int line;
    private final String reason;
    private final String remedy;

    /** @param line from 1; 0 if no line applies */
    public ModelFileException(String file, int line, String reason, String remedy) {
        this(file, line, reason, remedy, null);
    }

    /**
     * @param line from 1; 0 if no line applies
     * @param cause {@code null} if there is none
     */
    public ModelFileException(String file, int line, String reason, String remedy, Throwable cause) {
        super(file + (line > 0 ? ":" + line : "") + ": " + MessageText.shortened(reason) + "; " + remedy, cause);
        this.file = file;
        this.line = line;
        this.reason = reason;
        this.remedy = remedy;
    }

    public String file() {
        return file;
    }

    public int line() {
        return line;
    }

    public String reason() {
        return reason;
    }

    public String remedy() {
        return remedy;
    }
}
