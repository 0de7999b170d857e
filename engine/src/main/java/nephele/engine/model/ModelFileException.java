package nephele.engine.model;

import nephele.engine.asset.ShownText;

/** A file of a mesh, a curve or a scene that cannot be used: which one, where, why, and what its author can do about it. */
public final class ModelFileException extends RuntimeException {
    private static final long serialVersionUID = 1;

    private final String file;
    private final int line;
    private final String reason;
    private final String remedy;

    /** @param line the first is 1; 0 where no line is to blame */
    public ModelFileException(String file, int line, String reason, String remedy) {
        this(file, line, reason, remedy, null);
    }

    public ModelFileException(String file, int line, String reason, String remedy, Throwable cause) {
        super(file + (line > 0 ? ":" + line : "") + ": " + ShownText.shortened(reason) + "; " + remedy, cause);
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
