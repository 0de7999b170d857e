package nephele.app.play;

import java.util.function.Supplier;
import nephele.app.play.hud.HudContent;
import nephele.app.settings.Phrase;
import nephele.app.window.Control;
import nephele.engine.level.Hint;
import nephele.engine.level.Language;
import nephele.host.playthrough.HintClock;
import nephele.host.playthrough.Playthrough;

/**
 * Announces hints to the player, again from time to time, and gives them on request. Who asks too early
 * hears when one comes, and then has it without asking again.
 */
final class GivenHints {
    private static final double AGAIN_SECONDS = 45;
    /** A hint that is asked for so shortly before its time is given at once. */
    private static final double EARLY_SECONDS = 10;
    /** Longer times are told in minutes. */
    private static final double MOST_SECONDS = 99;

    private final Message message;
    private final Supplier<HudContent.Keys> keys;
    private Hint reported;
    private double reportedSeconds;
    private boolean isPromised;

    GivenHints(Message message, Supplier<HudContent.Keys> keys) {
        this.message = message;
        this.keys = keys;
    }

    /** Begins with a level. */
    void restart() {
        reported = null;
        isPromised = false;
    }

    /** Gives the hint that was promised when it is due, else names the key of the one that is offered, if any. */
    void offer(Playthrough walk) {
        offer(walk.hints(), walk.state().tick() * walk.secondsPerTick());
    }

    /** @param seconds of play in the level */
    void offer(HintClock hints, double seconds) {
        Hint offered = hints.offered();
        if (offered == null || message.showsHint() && !isPromised) {
            return;
        }
        if (isPromised) {
            give(hints);
        } else if (offered != reported || seconds - reportedSeconds >= AGAIN_SECONDS) {
            reported = offered;
            reportedSeconds = seconds;
            var shown = keys.get();
            message.sayHint(Phrase.HINT_OFFERED.in(shown.language(), shown.inSentence(Control.HINT)));
        }
    }

    /** Says the next hint, or the last one again with the time until the next. */
    void give(Playthrough walk) {
        give(walk.hints());
    }

    void give(HintClock hints) {
        Language language = keys.get().language();
        int before = hints.given();
        Hint hint = hints.give(EARLY_SECONDS);
        boolean isNew = hints.given() > before;
        double seconds = isNew ? Double.POSITIVE_INFINITY : hints.secondsToNext();
        isPromised = Double.isFinite(seconds);
        if (hint != null) {
            String again = isPromised ? " " + Phrase.HINT_NEXT.in(language, time(seconds)) : "";
            message.sayHint(Phrase.HINT_GIVEN.in(language, hints.given(), hints.all(), hint.text(language)) + again);
        } else if (isPromised) {
            message.sayHint(Phrase.HINT_COMES.in(language, time(seconds)));
        } else {
            message.sayHint((hints.all() == 0 ? Phrase.NO_HINTS : Phrase.NO_HINT_HERE).in(language));
        }
    }

    /** Returns a time that is not shorter: {@code 20 s}, {@code 3 min}. */
    private static String time(double seconds) {
        return seconds <= MOST_SECONDS
                ? Math.round(Math.ceil(seconds)) + " s"
                : Math.round(Math.ceil(seconds / 60)) + " min";
    }
}
