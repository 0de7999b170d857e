package nephele.engine.level.json;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.Problem;

/** Collects problems during the traversal of a document, with the current path. */
final class Problems {
    /** Number of messages that are kept; a file of a million faults must not cost a million messages. */
    private static final int MOST = 50;

    private final StringBuilder path = new StringBuilder(64);
    private final List<Problem> found = new ArrayList<>();
    private int count;

    /** Enters a member; pass the result to {@link #leave}. */
    int enter(String name) {
        int mark = path.length();
        if (mark > 0) {
            path.append('.');
        }
        path.append(JsonTree.printable(name));
        return mark;
    }

    int enter(int index) {
        int mark = path.length();
        path.append('[').append(index).append(']');
        return mark;
    }

    void leave(int mark) {
        path.setLength(mark);
    }

    /** Reports an error at the current path and returns {@code null}, the value of an unreadable part. */
    Object error(String message) {
        count++;
        if (found.size() < MOST) {
            found.add(Problem.error(path.length() == 0 ? "$" : path.toString(), message));
        } else if (found.size() == MOST) {
            found.add(Problem.error("$", "there are more errors; these are the first " + MOST));
        }
        return null;
    }

    int count() {
        return count;
    }

    List<Problem> found() {
        return found;
    }

    void throwIfAny(String file) {
        if (count > 0) {
            throw new LevelFormatException(file, found);
        }
    }
}
