package nephele.app.window;

import java.util.Set;

/**
 * The state of a gamepad's buttons and sticks.
 *
 * @param down the buttons and triggers that are pressed
 * @param leftX of the left stick, −1 to 1, to the right
 * @param leftY downwards
 */
public record PadState(Set<PadButton> down, double leftX, double leftY, double rightX, double rightY) {
    public static final PadState RELEASED = new PadState(Set.of(), 0, 0, 0, 0);

    /** Returns true while a button or trigger is pressed. */
    public boolean isDown(PadButton button) {
        return down.contains(button);
    }
}
