package nephele.app.play;

import nephele.app.play.hud.HudContent.Banner;
import nephele.app.settings.Phrase;
import nephele.engine.level.Language;
import nephele.host.named.LevelName;
import nephele.host.named.LevelTitles;

/** The banner in the upper part of the picture: what is being loaded, or the aim of a level that has just begun. */
final class Captions {
    private static final long AIM_NANOS = 6_000_000_000L;

    private final LevelTitles titles;
    private Session begun;
    private long begunNanos;

    Captions(LevelTitles titles) {
        this.titles = titles;
    }

    /** Shows the aim of a level from now on; of none if it is null. */
    void begin(Session session) {
        begun = session;
        begunNanos = System.nanoTime();
    }

    /** Returns the banner of a level that is being loaded. */
    Banner of(Loading loading, Language language) {
        return loading(loading.request().level(), loading.progress(language), language);
    }

    /** Returns the banner of a level that is loaded and whose first frame is drawn. */
    Banner preparing(LevelName level, Language language) {
        return loading(level, Phrase.PREPARING.in(language), language);
    }

    private Banner loading(LevelName level, String progress, Language language) {
        return new Banner(Phrase.LOADING.in(language) + " " + titles.of(level, language), progress);
    }

    /** Returns the aim of the running level for its first seconds; null if there is none to show. */
    Banner aim(Language language) {
        if (begun == null || System.nanoTime() - begunNanos > AIM_NANOS) {
            return null;
        }
        return GoalSight.text(begun.level(), language) == null ? null : goal(begun, language);
    }

    /** Returns the goal of a level below its title. */
    Banner goal(Session session, Language language) {
        return GoalSight.banner(session, titles.of(session.request().level(), language), language);
    }
}
