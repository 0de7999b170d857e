package nephele.app.window;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;

/**
 * A gamepad that plays and works in menus: its buttons are controls, the left stick walks, the right one turns the
 * view. In menus the left stick and the D-pad repeat while they are held.
 */
public final class Gamepad {
    /** The dead zone of a stick, as a fraction of its way. */
    static final double DEAD_ZONE = 0.18;

    /** The fraction of its way beyond which a trigger, or a stick in a menu, counts as pressed. */
    static final double PRESSED = 0.5;

    static final double FIRST_REPEAT_SECONDS = 0.4;
    static final double REPEAT_SECONDS = 0.12;
    private static final double FASTEST_COUNTS_PER_SECOND = 2500;

    /** Maps buttons of the pad to controls; most have another control in menus. */
    public enum Use {
        PLAY,
        MENU
    }

    private static final List<PadButton> BUTTONS = List.of(PadButton.values());

    private final Input input;
    private final Map<PadButton, Control> down = new EnumMap<>(PadButton.class);
    private PadButton repeating;
    private double untilRepeatSeconds;

    public Gamepad(Input input) {
        this.input = input;
    }

    /** Handles the present state of the pad; {@link PadState#RELEASED} if there is none. */
    public void update(PadState pad, Use use, double seconds) {
        for (int i = 0; i < BUTTONS.size(); i++) {
            PadButton button = BUTTONS.get(i);
            boolean isDown = pad.isDown(button) || use == Use.MENU && isStick(pad, button);
            if (isDown != down.containsKey(button)) {
                change(button, isDown, use);
            }
        }
        repeat(use, seconds);
        input.walk(
                -beyondDeadZone(pad.leftX(), pad.leftY(), pad.leftY()),
                beyondDeadZone(pad.leftX(), pad.leftY(), pad.leftX()));
        if (use == Use.PLAY) {
            double counts = FASTEST_COUNTS_PER_SECOND * seconds;
            double right = beyondDeadZone(pad.rightX(), pad.rightY(), pad.rightX());
            double downward = beyondDeadZone(pad.rightX(), pad.rightY(), pad.rightY());
            input.turn(counts * right * Math.abs(right), counts * downward * Math.abs(downward));
        }
    }

    private void change(PadButton button, boolean isDown, Use use) {
        Control control = isDown ? button.control(use) : down.get(button);
        if (!isDown) {
            down.remove(button);
            repeating = repeating == button ? null : repeating;
        } else {
            down.put(button, control);
            repeating = use == Use.MENU && isDirection(button) ? button : null;
            untilRepeatSeconds = FIRST_REPEAT_SECONDS;
        }
        if (isDown && input.isCapturing()) {
            if (button == PadButton.B) {
                input.cancelCapture();
            }
        } else if (control != null) {
            input.padControl(control, isDown);
        }
    }

    private void repeat(Use use, double seconds) {
        if (repeating == null || use != Use.MENU) {
            return;
        }
        untilRepeatSeconds -= seconds;
        if (untilRepeatSeconds <= 0) {
            untilRepeatSeconds = REPEAT_SECONDS;
            input.padControl(repeating.control(use), true);
        }
    }

    private static boolean isDirection(PadButton button) {
        return button.compareTo(PadButton.UP) >= 0 && button.compareTo(PadButton.LEFT) <= 0;
    }

    private static boolean isStick(PadState pad, PadButton button) {
        return switch (button) {
            case UP -> pad.leftY() < -PRESSED;
            case DOWN -> pad.leftY() > PRESSED;
            case LEFT -> pad.leftX() < -PRESSED;
            case RIGHT -> pad.leftX() > PRESSED;
            default -> false;
        };
    }

    /** Returns a component of a stick with the dead zone cut out of its middle, −1 to 1. */
    private static double beyondDeadZone(double x, double y, double component) {
        double length = Math.hypot(x, y);
        if (length <= DEAD_ZONE) {
            return 0;
        }
        double moved = Math.min(1, (length - DEAD_ZONE) / (1 - DEAD_ZONE));
        return component / length * moved;
    }
}
