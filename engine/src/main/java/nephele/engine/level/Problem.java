package nephele.engine.level;

import java.util.List;
import nephele.engine.asset.MessageText;
import nephele.engine.math.Vec3;

/**
 * A problem of a level.
 *
 * @param isError true if the level cannot be played with it, false for a warning
 * @param path JSON path such as {@code solids[3].size}; {@code $} is the whole file
 * @param subject what it is about, for programs that show or repair it
 */
public record Problem(boolean isError, String path, String message, Subject subject) {
    public Problem {
        path = MessageText.shortened(path);
        message = MessageText.shortened(message);
    }

    /** The kind of a problem, for programs that offer a remedy. */
    public enum Topic {
        GENERAL,
        DUPLICATE_ID,
        MISSING_MATERIAL,
        MISSING_ASSET,
        NO_VIEWPOINT,
        NO_VOLUME,
        TOO_THIN,
        INSIDE_ANOTHER,
        FIGHTING_FACES,
        TOO_SMALL_FOR_PORTAL,
        ENTITY_IN_SOLID,
        LIGHT_WITHOUT_EFFECT,
        LEAK
    }

    /**
     * What a problem is about.
     *
     * @param otherPaths JSON paths of what else takes part
     * @param place in world metres: the corners of an area or the points of a line; empty where the records say it
     */
    public record Subject(Topic topic, List<String> otherPaths, List<Vec3> place) {
        public static final Subject GENERAL = new Subject(Topic.GENERAL, List.of(), List.of());

        public Subject {
            otherPaths = List.copyOf(otherPaths);
            place = List.copyOf(place);
        }
    }

    /** Returns a problem that prevents play. */
    public static Problem error(String path, String message) {
        return new Problem(true, path, message, Subject.GENERAL);
    }

    public static Problem warning(String path, String message) {
        return new Problem(false, path, message, Subject.GENERAL);
    }

    /** Returns this problem with a topic. */
    public Problem about(Topic topic) {
        return about(new Subject(topic, List.of(), List.of()));
    }

    /** Returns this problem with another subject. */
    public Problem about(Subject other) {
        return new Problem(isError, path, message, other);
    }

    /** Returns {@code file: json.path: message}. */
    public String line(String file) {
        return file + ": " + path + ": " + (isError ? "" : "warning: ") + message;
    }
}
