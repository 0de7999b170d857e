package nephele.engine.xmlscene;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.function.Supplier;
import nephele.engine.model.ModelFileException;
import nephele.engine.xmlscene.XmlScene.XmlWarning;

/** Warnings about one file. The first thousand are kept, which bounds the memory. */
final class SceneWarnings {
    private static final int MOST = 1000;

    private final String file;
    private final List<XmlWarning> warnings = new ArrayList<>();
    private int more;

    SceneWarnings(String file) {
        this.file = file;
    }

    void warn(int line, String message) {
        warn(line, () -> message);
    }

    /** @param message not evaluated if the warning is not kept */
    void warn(int line, Supplier<String> message) {
        if (warnings.size() < MOST) {
            warnings.add(new XmlWarning(line, message.get()));
        } else {
            more++;
        }
    }

    ModelFileException error(int line, String reason, String remedy) {
        return new ModelFileException(file, line, reason, remedy);
    }

    List<XmlWarning> byLine() {
        List<XmlWarning> sorted = new ArrayList<>(warnings);
        sorted.sort(Comparator.comparingInt(XmlWarning::line));
        if (more > 0) {
            sorted.add(new XmlWarning(sorted.get(MOST - 1).line(), "and " + more + " more warnings"));
        }
        return List.copyOf(sorted);
    }

    /** Returns text of a file for a message: short, on one line, without control characters. */
    static String quoted(String text) {
        String start = text.length() <= 40 ? text : text.substring(0, 40) + "…";
        return "'" + start.strip().replaceAll("\\p{Cntrl}+", " ") + "'";
    }
}
