package nephele.engine.level;

import nephele.engine.asset.MessageText;

/**
 * A problem of a level.
 *
 * @param path JSON path such as {@code solids[3].size}; {@code $} is the whole file
 */
public record Problem(Severity severity, String path, String message) {
    public Problem {
        path = MessageText.shortened(path);
        message = MessageText.shortened(message);
    }

    /** Severity of a problem: a level with an ERROR cannot be played, one with a WARNING can. */
    public enum Severity {
        ERROR,
        WARNING
    }

    /** Returns a problem that prevents play. */
    public static Problem error(String path, String message) {
        return new Problem(Severity.ERROR, path, message);
    }

    public static Problem warning(String path, String message) {
        return new Problem(Severity.WARNING, path, message);
    }

    /** Returns true if the problem prevents play. */
    public boolean isError() {
        return severity == Severity.ERROR;
    }

    /** Returns {@code file: json.path: message}. */
    public String line(String file) {
        return file + ": " + path + ": " + (isError() ? "" : "warning: ") + message;
    }
}
