package nephele.app.play;

import java.util.List;
import nephele.app.window.Control;
import nephele.app.window.Input;
import nephele.host.compare.Wipe;

/** Moves the wipe between two compared techniques by the arrow keys, which do not walk meanwhile. */
public final class WipeControl {
    private static final String LEFT = "Left";
    private static final String RIGHT = "Right";
    private static final String ALL_RIGHT = "Home";
    private static final String ALL_LEFT = "End";
    /** The names of its keys. */
    public static final List<String> KEYS = List.of(LEFT, RIGHT, ALL_RIGHT, ALL_LEFT);

    /** Fractions of the width that a press moves it, and a held key in a second; with Shift it is finer. */
    private static final double STEP = 0.02;

    private static final double PER_SECOND = 0.4;
    private static final double FINE = 0.1;
    /** The longest time that a held key counts in one frame. */
    private static final double LONGEST_SECONDS = 0.1;

    private final Input input;
    private Wipe wipe = Wipe.MIDDLE;

    public WipeControl(Input input) {
        this.input = input;
    }

    public Wipe wipe() {
        return wipe;
    }

    /** Leaves the arrows to the controls: nothing is compared, or a menu is open. */
    public void rest() {
        input.reserved().reserve(List.of());
    }

    /** Obeys the keys since the last frame. */
    public void update(double seconds) {
        input.reserved().reserve(KEYS);
        double scale = input.holds(Control.RUN) ? FINE : 1;
        double held = scale * PER_SECOND * Math.min(seconds, LONGEST_SECONDS);
        double by =
                (input.reserved().holds(RIGHT) ? held : 0) - (input.reserved().holds(LEFT) ? held : 0);
        wipe = by == 0 ? wipe : wipe.moved(by);
        for (var key = input.reserved().nextPressed();
                key != null;
                key = input.reserved().nextPressed()) {
            wipe = switch (key) {
                case LEFT -> wipe.moved(-STEP * scale);
                case RIGHT -> wipe.moved(STEP * scale);
                case ALL_RIGHT -> new Wipe(0);
                default -> new Wipe(1);
            };
        }
    }
}
