package nephele.scenes.xml;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import nephele.engine.asset.MessageText;
import nephele.engine.model.ModelFileException;
import nephele.scenes.xml.XmlScene.XmlWarning;

/** Warnings about one file: equal ones are counted. The first thousand kinds are kept, which bounds the memory. */
final class SceneWarnings {
    private static final int MOST = 1000;
    private static final int MOST_COUNTED = 50_000;

    private final String file;
    private final Map<String, Kind> kinds = new LinkedHashMap<>();
    private int counted;
    private int more;

    /** Equal warnings. @param line of the first */
    private record Kind(int line, int count) {}

    SceneWarnings(String file) {
        this.file = file;
    }

    void warn(int line, String message) {
        warn(line, () -> message);
    }

    /** @param message not evaluated beyond {@link #MOST_COUNTED} warnings, which bounds the time */
    void warn(int line, Supplier<String> message) {
        counted++;
        String text = counted > MOST_COUNTED ? null : message.get();
        if (text != null && (kinds.size() < MOST || kinds.containsKey(text))) {
            kinds.merge(text, new Kind(line, 1), (before, now) -> new Kind(before.line, before.count + 1));
        } else {
            more++;
        }
    }

    ModelFileException error(int line, String reason, String remedy) {
        return new ModelFileException(file, line, reason, remedy);
    }

    /** Returns a warning for each kind, in the order of their first lines. */
    List<XmlWarning> byLine() {
        List<XmlWarning> sorted = new ArrayList<>();
        kinds.forEach((message, kind) ->
                sorted.add(new XmlWarning(kind.line, MessageText.shortened(message) + MessageText.times(kind.count))));
        sorted.sort(Comparator.comparingInt(XmlWarning::line));
        if (more > 0) {
            sorted.add(new XmlWarning(sorted.get(sorted.size() - 1).line(), "and " + more + " more warnings"));
        }
        return List.copyOf(sorted);
    }

    /** Returns text of a file for a message: short, on one line, without control characters. */
    static String quoted(String text) {
        String start = text.length() <= 40 ? text : text.substring(0, 40) + "…";
        return "'" + start.strip().replaceAll("\\p{Cntrl}+", " ") + "'";
    }
}
