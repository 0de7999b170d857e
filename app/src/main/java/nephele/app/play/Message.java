package nephele.app.play;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import nephele.app.settings.Phrase;
import nephele.engine.level.Language;
import nephele.engine.portal.placement.PlacementResult;
import nephele.engine.sim.state.TickEvent;
import nephele.engine.sim.state.TickEvent.Handled;

/**
 * The latest lines for the player; each disappears when there has been time to read it. A hint stays below the others,
 * where it is seen in the smallest window too, and takes asides away.
 */
final class Message {
    private static final int MOST_LINES = 3;
    private static final long LEAST_NANOS = 4_000_000_000L;
    /** The time in which somebody who plays notices a line, and that for reading it. */
    private static final long NOTICE_NANOS = 2_000_000_000L;

    private static final long NANOS_PER_LETTER = 60_000_000L;

    private final Supplier<Language> language;
    private final LongSupplier clock;
    private final List<Line> lines = new ArrayList<>();
    private List<String> texts = List.of();

    /** The kinds of lines. */
    private enum Kind {
        /** A line that a hint takes away. */
        ASIDE,
        USUAL,
        /** A line that the player asked for; there is one at most. */
        HINT
    }

    private record Line(String text, long untilNanos, Kind kind) {}

    /** @param language of the phrases that follow */
    Message(Supplier<Language> language) {
        this(language, System::nanoTime);
    }

    /** @param clock in nanoseconds */
    Message(Supplier<Language> language, LongSupplier clock) {
        this.language = language;
        this.clock = clock;
    }

    /** Shows a line; one that is shown already starts anew. */
    void say(String text) {
        say(text, Kind.USUAL);
    }

    void say(Phrase phrase) {
        say(phrase.in(language.get()));
    }

    void say(Phrase phrase, Object value) {
        say(phrase.in(language.get(), value));
    }

    /** Shows a line that is taken away when a hint comes. */
    void sayAside(String text) {
        say(text, Kind.ASIDE);
    }

    /** Shows a hint, or a line about hints, in the place of the one before. */
    void sayHint(String text) {
        lines.removeIf(line -> line.kind != Kind.USUAL);
        say(text, Kind.HINT);
    }

    private void say(String text, Kind kind) {
        lines.removeIf(line -> line.text.equals(text));
        if (lines.size() == MOST_LINES) {
            lines.remove(0);
        }
        long nanos = Math.max(LEAST_NANOS, NOTICE_NANOS + text.length() * NANOS_PER_LETTER);
        int end = showsHint() ? lines.size() - 1 : lines.size();
        lines.add(end, new Line(text, clock.getAsLong() + nanos, kind));
        changed();
    }

    /** Returns true while a hint, or a line about hints, can be read. */
    boolean showsHint() {
        return !lines.isEmpty() && lines.get(lines.size() - 1).kind == Kind.HINT;
    }

    /** Returns the lines to show, the latest last, but below it a hint. Allocates nothing while they stay the same. */
    List<String> texts() {
        if (!lines.isEmpty() && lines.removeIf(line -> clock.getAsLong() - line.untilNanos > 0)) {
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

    /** The message for an event of a tick: only events that prevented an action have one. */
    static Optional<String> ofEvent(TickEvent event, Language language) {
        if (event instanceof TickEvent.PortalRefused refused) {
            long millimetres = PlacementResult.Refused.millimetres(refused.unevenMetres());
            return Optional.of(ofRefusal(refused.reason(), millimetres, language));
        }
        if (event instanceof TickEvent.BodyReturned) {
            return Optional.of(Phrase.RETURNED.in(language));
        }
        if (event instanceof Handled handled) {
            return switch (handled.kind()) {
                case TOO_HEAVY -> Optional.of(Phrase.TOO_HEAVY.in(language));
                case LOST -> Optional.of(Phrase.LOST.in(language));
                case PICKED_UP, DROPPED, THROWN -> Optional.empty();
            };
        }
        return Optional.empty();
    }

    /** @param unevenMillimetres by how much the ground is uneven, if that is the reason */
    static String ofRefusal(PlacementResult.Refusal reason, long unevenMillimetres, Language language) {
        return Phrase.NO_PORTAL.in(language, Phrase.ofRefusal(reason).in(language, unevenMillimetres));
    }
}
