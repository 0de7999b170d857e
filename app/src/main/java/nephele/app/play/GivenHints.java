package nephele.app.play;

import java.util.function.Supplier;
import nephele.app.play.hud.HudContent;
import nephele.app.text.Phrase;
import nephele.app.window.Control;
import nephele.engine.level.Hint;
import nephele.engine.playthrough.HintClock;
import nephele.engine.playthrough.Playthrough;

/** Tells the player that there is a hint, again from time to time, and the hint when it is asked for. */
final class GivenHints {
    private static final double AGAIN_SECONDS = 45;

    private final Message message;
    private final Supplier<HudContent.Keys> keys;
    private Hint told;
    private long toldTick;

    GivenHints(Message message, Supplier<HudContent.Keys> keys) {
        this.message = message;
        this.keys = keys;
    }

    /** Begins with a level. */
    void restart() {
        told = null;
    }

    /** Names the key of the hint that is offered, if any. */
    void offer(Playthrough walk) {
        Hint offered = walk.hints().offered();
        long tick = walk.state().tick();
        boolean isNews = offered != told || (tick - toldTick) * walk.secondsPerTick() >= AGAIN_SECONDS;
        if (offered != null && isNews) {
            told = offered;
            toldTick = tick;
            var shown = keys.get();
            message.say(Phrase.HINT_OFFERED.in(shown.language(), shown.inSentence(Control.HINT)));
        }
    }

    /** Says the next hint, or the last one again. */
    void give(Playthrough walk) {
        HintClock hints = walk.hints();
        var language = keys.get().language();
        Hint hint = hints.give();
        if (hint != null) {
            message.say(Phrase.HINT_GIVEN.in(language, hints.given(), hints.all(), hint.text(language)));
        } else {
            message.say(hints.all() == 0 ? Phrase.NO_HINTS : Phrase.NO_HINT_YET);
        }
    }
}
