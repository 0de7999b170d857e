package nephele.scenes.file;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.Consumer;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import nephele.engine.asset.MessageText;

/**
 * Warnings about places of files, one for each kind: equal messages at different lines are reported once, with the first
 * line and their number.
 */
final class CountedWarnings implements Consumer<String> {
    private static final Pattern PLACED = Pattern.compile("(.*?:\\d+): (.*)", Pattern.DOTALL);

    private final Map<String, Kind> kinds = new LinkedHashMap<>();
    private Consumer<String> listener;

    private record Kind(String first, int count) {}

    /** Adds a warning of the form {@code FILE:LINE: MESSAGE}; others are kinds of their own. */
    @Override
    public void accept(String warning) {
        if (listener != null) {
            listener.accept(warning);
            return;
        }
        Matcher placed = PLACED.matcher(warning);
        kinds.merge(
                placed.matches() ? placed.group(2) : warning,
                new Kind(warning, 1),
                (before, added) -> new Kind(before.first, before.count + 1));
    }

    /** Passes on a line for each kind, in the order of their first warnings; later warnings are passed on at once. */
    void report(Consumer<String> lines) {
        listener = lines;
        kinds.values().forEach(kind -> lines.accept(kind.first + MessageText.times(kind.count)));
    }
}
