package nephele.app.play.hud;

import java.util.List;
import nephele.app.window.Input;
import nephele.app.window.KeyBindings;
import nephele.engine.compare.Wipe;
import nephele.engine.level.Language;
import nephele.engine.playthrough.CrosshairState;
import nephele.engine.scene.ShotPalette;

/**
 * The content of the overlay, as a value.
 *
 * @param menu null while playing
 * @param figures lines of the F3 panel, empty if it is closed
 * @param messages the latest ones, the last one last
 * @param banner what is being loaded, or the level's aim; null for none
 * @param sight null if there is no crosshair
 * @param comparison null unless two techniques are compared
 */
public record HudContent(
        Menu menu,
        Page page,
        List<Figure> figures,
        List<String> messages,
        Banner banner,
        Sight sight,
        Comparison comparison,
        Keys keys) {
    /**
     * Two compared techniques.
     *
     * @param left label of the left side, {@code right} likewise
     * @param difference what is measured between them; empty before that
     */
    public record Comparison(Wipe wipe, String left, String right, String difference) {}

    /** The keys of the help page, those of the device that the player uses, and its language. */
    public record Keys(KeyBindings bindings, Input.Device device, Language language) {}

    /** The crosshair, the colours of its halves, and a line below it; null for none. */
    public record Sight(CrosshairState crosshair, ShotPalette palette, String prompt) {}

    /** A title and a line in the upper part of the picture. */
    public record Banner(String title, String line) {}

    /** The page that covers the game, if any. */
    public enum Page {
        NONE,
        HELP
    }

    /** A line of the F3 panel. */
    public record Figure(String name, String value) {}
}
