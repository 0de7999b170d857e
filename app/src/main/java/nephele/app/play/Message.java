package nephele.app.play;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import nephele.app.text.Phrase;
import nephele.engine.level.Language;

/** The latest lines for the player; each disappears when there has been time to read it. */
final class Message {
    private static final int MOST_LINES = 3;
    private static final long LEAST_NANOS = 4_000_000_000L;
    /** The time in which somebody who plays notices a line, and that for reading it. */
    private static final long NOTICE_NANOS = 2_000_000_000L;

    private static final long NANOS_PER_LETTER = 60_000_000L;

    private final Supplier<Language> language;
    private final List<Line> lines = new ArrayList<>();
    private List<String> texts = List.of();

    private record Line(String text, long untilNanos) {}

    /** @param language of the phrases that follow */
    Message(Supplier<Language> language) {
        this.language = language;
    }

    /** Shows a line; one that is shown already starts anew. */
    void say(String text) {
        lines.removeIf(line -> line.text.equals(text));
        if (lines.size() == MOST_LINES) {
            lines.remove(0);
        }
        long nanos = Math.max(LEAST_NANOS, NOTICE_NANOS + text.length() * NANOS_PER_LETTER);
        lines.add(new Line(text, System.nanoTime() + nanos));
        changed();
    }

    void say(Phrase phrase) {
        say(phrase.in(language.get()));
    }

    void say(Phrase phrase, Object value) {
        say(phrase.in(language.get(), value));
    }

    /** Returns the lines to show, the latest last. Allocates nothing while they stay the same. */
    List<String> texts() {
        if (!lines.isEmpty() && lines.removeIf(line -> System.nanoTime() - line.untilNanos > 0)) {
            changed();
        }
        return texts;
    }

    /** Takes all lines away. */
    void clear() {
        lines.clear();
        changed();
    }

    private void changed() {
        texts = lines.stream().map(Line::text).toList();
    }
}
