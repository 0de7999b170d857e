package nephele.engine.level;

import nephele.engine.asset.MessageText;

/**
 * Something wrong in a level.
 *
 * @param path JSON path such as {@code solids[3].size}; {@code $} is the whole file
 */
public record Problem(Severity severity, String path, String message) {
    public Problem {
        path = MessageText.shortened(path);
        message = MessageText.shortened(message);
    }

    /** An ERROR keeps the level from being played, a WARNING does not. */
    public enum Severity {
        ERROR,
        WARNING
    }

    public static Problem error(String path, String message) {
        return new Problem(Severity.ERROR, path, message);
    }

    public static Problem warning(String path, String message) {
        return new Problem(Severity.WARNING, path, message);
    }

    public boolean isError() {
        return severity == Severity.ERROR;
    }

    /** {@code file: json.path: message}. */
    public String line(String file) {
        return file + ": " + path + ": " + (isError() ? "" : "warning: ") + message;
    }
}
