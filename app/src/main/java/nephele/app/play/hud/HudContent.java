package nephele.app.play.hud;

import java.util.List;
import nephele.engine.walk.Sights;

/**
 * Everything that lies over the picture, as a value.
 *
 * @param menu null while playing
 * @param figures lines of the F3 panel, empty when it is closed
 * @param message null, or what happened just now
 */
public record HudContent(Menu menu, Page page, List<Figure> figures, String message, Sights sights) {
    /** The page that covers the game, if any. */
    public enum Page {
        NONE,
        HELP
    }

    /** A line of the F3 panel. */
    public record Figure(String name, String value) {}
}
