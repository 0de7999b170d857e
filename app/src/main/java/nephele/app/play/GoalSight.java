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

/** The goal of a level: its text, and where in the picture it is. */
final class GoalSight {
    private GoalSight() {}

    /**
     * Returns the goal in words; of a level that says none a line that says so.
     *
     * @param title of the level
     */
    static Banner banner(Session session, String title, Language language) {
        String goal = text(session.level(), language);
        return new Banner(title, goal == null ? Phrase.NO_GOAL.in(language) : goal);
    }

    /** Returns the goal in a language, or in English; {@code null} if the level says none. */
    static String text(Level level, Language language) {
        return level.aim().getOrDefault(language, level.aim().get(Language.EN));
    }

    /** Returns the mark of the landmark, or of the nearest exit; {@code null} if there is neither. */
    static GoalMark mark(Level level, View view, Area area) {
        Place place = place(level, view.eye());
        if (place == null) {
            return null;
        }
        Vec3 way = place.position().minus(view.eye());
        double depth = -view.alongBack(way.x(), way.y(), way.z());
        double pointsPerUnit = area.height() / 2 / view.projection().tanHalfHeight();
        double least = Math.max(depth, 1e-3);
        double right = view.alongRight(way.x(), way.y(), way.z()) / least * pointsPerUnit;
        double up = view.alongUp(way.x(), way.y(), way.z()) / least * pointsPerUnit;
        return GoalMark.at(
                area, depth > 0, right, -up, place.radiusMetres() / least * pointsPerUnit, Math.round(way.length()));
    }

    private static Place place(Level level, Vec3 eye) {
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
