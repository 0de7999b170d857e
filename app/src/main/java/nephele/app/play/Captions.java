package nephele.app.play;

import java.util.List;
import nephele.app.play.hud.Area;
import nephele.app.play.hud.GoalMark;
import nephele.app.play.hud.HudContent.Banner;
import nephele.app.settings.Phrase;
import nephele.engine.level.Exit;
import nephele.engine.level.Language;
import nephele.engine.level.Level;
import nephele.engine.level.Place;
import nephele.engine.math.Vec3;
import nephele.engine.scene.View;
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
        return goalText(begun.level(), language) == null ? null : goal(begun, language);
    }

    /** Returns the goal of a level below its title. */
    Banner goal(Session session, Language language) {
        return goalBanner(session, titles.of(session.request().level(), language), language);
    }

    /**
     * Returns the goal in words; of a level that says none a line that says so.
     *
     * @param title of the level
     */
    private static Banner goalBanner(Session session, String title, Language language) {
        String goal = goalText(session.level(), language);
        return new Banner(title, goal == null ? Phrase.NO_GOAL.in(language) : goal);
    }

    /** Returns the goal in a language, or in English; {@code null} if the level says none. */
    static String goalText(Level level, Language language) {
        return level.aim().getOrDefault(language, level.aim().get(Language.EN));
    }

    /** Returns the mark of the landmark, or of the nearest exit; {@code null} if there is neither. */
    static GoalMark goalMark(Level level, View view, Area area) {
        Place place = goalPlace(level, view.eye());
        if (place == null) {
            return null;
        }
        Vec3 path = place.position().minus(view.eye());
        double depth = -view.alongBack(path.x(), path.y(), path.z());
        double pointsPerUnit = area.height() / 2 / view.projection().tanHalfHeight();
        double least = Math.max(depth, 1e-3);
        double right = view.alongRight(path.x(), path.y(), path.z()) / least * pointsPerUnit;
        double up = view.alongUp(path.x(), path.y(), path.z()) / least * pointsPerUnit;
        return GoalMark.at(
                area, depth > 0, right, -up, place.radiusMetres() / least * pointsPerUnit, Math.round(path.length()));
    }

    private static Place goalPlace(Level level, Vec3 eye) {
        Place nearest = level.landmark();
        for (Exit exit : level.landmark() == null ? level.exits() : List.<Exit>of()) {
            Vec3 middle = exit.feet().plus(new Vec3(0, exit.heightMetres() / 2, 0));
            boolean isNearer = nearest == null
                    || middle.minus(eye).length()
                            < nearest.position().minus(eye).length();
            nearest = isNearer ? new Place(middle, Math.max(exit.radiusMetres(), exit.heightMetres() / 2)) : nearest;
        }
        return nearest;
    }
}
