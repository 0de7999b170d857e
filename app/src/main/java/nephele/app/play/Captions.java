package nephele.app.play;

import nephele.app.play.hud.HudContent.Banner;
import nephele.app.text.Phrase;
import nephele.engine.level.Language;
import nephele.engine.named.LevelName;

/** The banner in the upper part of the picture: what is being loaded, or the aim of a level that has just begun. */
final class Captions {
    private static final long AIM_NANOS = 6_000_000_000L;

    private Session begun;
    private long begunNanos;

    /** Shows the aim of a level from now on; of none if it is null. */
    void begin(Session session) {
        begun = session;
        begunNanos = System.nanoTime();
    }

    /** Returns the banner of a level that is being loaded. */
    static Banner of(Loading loading, Language language) {
        return new Banner(
                Phrase.LOADING.in(language) + " " + loading.request().level().title(), loading.progress(language));
    }

    /** Returns the banner of a level that is loaded and whose first frame is drawn. */
    static Banner preparing(LevelName level, Language language) {
        return new Banner(Phrase.LOADING.in(language) + " " + level.title(), Phrase.PREPARING.in(language));
    }

    /** Returns the aim of the running level for its first seconds; null if there is none to show. */
    Banner aim(Language language) {
        if (begun == null || System.nanoTime() - begunNanos > AIM_NANOS) {
            return null;
        }
        return GoalSight.text(begun.level(), language) == null ? null : GoalSight.banner(begun, language);
    }
}
