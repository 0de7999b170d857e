package nephele.app.play.hud;

import java.util.List;
import java.util.stream.Collectors;
import nephele.app.settings.Phrase;
import nephele.app.window.Control;
import nephele.app.window.Input;
import nephele.app.window.KeyBindings;
import nephele.app.window.PadButton;
import nephele.engine.level.Language;
import nephele.engine.scene.ShotPalette;
import nephele.host.compare.Wipe;
import nephele.host.playthrough.CrosshairState;

/**
 * The content of the overlay, as a value.
 *
 * @param menu null while playing
 * @param figures lines of the F3 panel, empty if it is closed
 * @param messages the latest ones, the last one last
 * @param banner what is being loaded, or the level's aim; null for none
 * @param sight null if there is no crosshair
 * @param comparison null unless two techniques are compared
 * @param goal the goal of the level, for the page of keys; null for none
 */
public record HudContent(
        Menu menu,
        Page page,
        List<Figure> figures,
        List<String> messages,
        Banner banner,
        Sight sight,
        Comparison comparison,
        Keys keys,
        Banner goal) {
    /**
     * Two compared techniques.
     *
     * @param left label of the left side, {@code right} likewise
     * @param difference what is measured between them; empty before that
     */
    public record Comparison(Wipe wipe, String left, String right, String difference) {}

    /** The keys of the player's device, and the player's language. */
    public record Keys(KeyBindings bindings, Input.Device device, Language language) {
        private static final String NO_KEY = "–";

        /** Returns the keys of a control; of a gamepad its button where it has one, and L for the left stick. */
        public String names(Control control) {
            if (device == Input.Device.GAMEPAD) {
                String stick =
                        switch (control) {
                            case FORWARD -> "L ↑";
                            case BACK -> "L ↓";
                            case LEFT -> "L ←";
                            case RIGHT -> "L →";
                            case CONFIRM -> "A";
                            default -> null;
                        };
                PadButton button = PadButton.of(control);
                if (stick != null || button != null) {
                    return stick != null ? stick : button.title();
                }
            }
            return bindings.keys(control).stream()
                    .map(key -> Phrase.ofKey(key, language))
                    .collect(Collectors.joining(", "));
        }

        /** Returns the first key of a control for a sentence, in which mouse buttons are clicks; a dash for none. */
        public String inSentence(Control control) {
            if (device == Input.Device.GAMEPAD && PadButton.of(control) != null) {
                return PadButton.of(control).title();
            }
            List<String> keys = bindings.keys(control);
            return keys.isEmpty() ? NO_KEY : Phrase.ofKeyInSentence(keys.get(0), language);
        }

        /** Returns what turns the view. */
        public String look() {
            return device == Input.Device.GAMEPAD ? "R" : Phrase.MOUSE.in(language);
        }

        /** Returns what walks: the left stick, or the first key of each direction; empty if one has none. */
        public String walk() {
            if (device == Input.Device.GAMEPAD) {
                return "L";
            }
            List<Control> directions = List.of(Control.FORWARD, Control.LEFT, Control.BACK, Control.RIGHT);
            boolean hasAll = directions.stream()
                    .noneMatch(direction -> bindings.keys(direction).isEmpty());
            return hasAll ? directions.stream().map(this::inSentence).collect(Collectors.joining(" ")) : "";
        }

        /** Returns the meaning of a control. */
        public String meaning(Control control) {
            return withRun(Phrase.ofControl(control));
        }

        /** Returns a phrase whose placeholder is the key that runs. */
        public String withRun(Phrase phrase) {
            return phrase.in(language, inSentence(Control.RUN));
        }
    }

    /**
     * The crosshair, the colours of its halves, a line below it and where the goal is.
     *
     * @param prompt null for none
     * @param goal null for none
     */
    public record Sight(CrosshairState crosshair, ShotPalette palette, String prompt, GoalMark goal) {}

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
