package nephele.app.play;

import java.util.function.Supplier;
import nephele.app.settings.GameSettings;
import nephele.app.settings.Settings;
import nephele.app.settings.Settings.Crouch;
import nephele.app.settings.Settings.Switch;
import nephele.app.window.Control;
import nephele.app.window.Input;
import nephele.engine.sim.player.MouseLook;
import nephele.engine.sim.state.PlayerInput;
import nephele.engine.sim.state.PlayerInput.Action;
import nephele.host.playthrough.TickInput;

/**
 * Converts keyboard, mouse and gamepad to the integer input of a tick. All motion since the last tick belongs to the next one.
 */
final class LiveInput implements TickInput {
    private static final double DEGREES_PER_COUNT = 0.08;
    private static final int FULL_SPEED = 100;

    private final Input input;
    private final Supplier<GameSettings> settings;
    private final MouseLook mouseLook = new MouseLook(DEGREES_PER_COUNT);
    private boolean crouches;
    private boolean heldCrouch;

    /** @param settings the player's present settings */
    LiveInput(Input input, Supplier<GameSettings> settings) {
        this.input = input;
        this.settings = settings;
    }

    @Override
    public PlayerInput next() {
        int forward = axis(Control.FORWARD, Control.BACK, input.walkForward());
        int right = axis(Control.RIGHT, Control.LEFT, input.walkRight());
        var walking = PlayerInput.NONE.walking(forward, right);
        var acting = walking;
        for (int i = 0; i < Action.ALL.size(); i++) {
            Action action = Action.ALL.get(i);
            acting = isHeld(action) ? acting.holding(action) : acting;
        }
        double speed = settings.get().get(Settings.MOUSE_SPEED);
        double down = settings.get().get(Settings.INVERT_MOUSE) == Switch.ON ? -speed : speed;
        return mouseLook.turn(acting, speed * input.takeCountsRight(), down * input.takeCountsDown());
    }

    private boolean isHeld(Action action) {
        boolean isDown = input.takeHold(control(action));
        if (action != Action.CROUCH || settings.get().get(Settings.CROUCH) == Crouch.HOLD) {
            return isDown;
        }
        crouches ^= isDown && !heldCrouch;
        heldCrouch = isDown;
        return crouches;
    }

    private static Control control(Action action) {
        return switch (action) {
            case RUN -> Control.RUN;
            case CROUCH -> Control.CROUCH;
            case JUMP -> Control.JUMP;
            case FIRE_FIRST -> Control.FIRE_FIRST;
            case FIRE_SECOND -> Control.FIRE_SECOND;
            case CARRY -> Control.CARRY;
            case THROW -> Control.THROW;
        };
    }

    @Override
    public boolean isFinished() {
        return false;
    }

    private int axis(Control positive, Control negative, double stick) {
        int keys = (input.holds(positive) ? FULL_SPEED : 0) - (input.holds(negative) ? FULL_SPEED : 0);
        return Math.max(-FULL_SPEED, Math.min(FULL_SPEED, keys + (int) Math.rint(FULL_SPEED * stick)));
    }
}
