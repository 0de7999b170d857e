package nephele.app.window;

import static org.lwjgl.glfw.GLFW.*;

import java.util.EnumSet;
import org.lwjgl.glfw.GLFWGamepadState;

/** Reads the first gamepad that the system knows; needs GLFW. */
final class PadReader implements AutoCloseable {
    private final GLFWGamepadState state = GLFWGamepadState.calloc();

    /** Returns the pad's state; {@link PadState#RELEASED} without a pad. Allocates nothing then. */
    PadState read() {
        for (int joystick = GLFW_JOYSTICK_1; joystick <= GLFW_JOYSTICK_LAST; joystick++) {
            if (glfwJoystickPresent(joystick)
                    && glfwJoystickIsGamepad(joystick)
                    && glfwGetGamepadState(joystick, state)) {
                return state();
            }
        }
        return PadState.RELEASED;
    }

    private PadState state() {
        var down = EnumSet.noneOf(PadButton.class);
        for (PadButton button : PadButton.values()) {
            if (button.ordinal() <= GLFW_GAMEPAD_BUTTON_LAST && state.buttons(button.ordinal()) == GLFW_PRESS) {
                down.add(button);
            }
        }
        addIfPulled(down, PadButton.LT, GLFW_GAMEPAD_AXIS_LEFT_TRIGGER);
        addIfPulled(down, PadButton.RT, GLFW_GAMEPAD_AXIS_RIGHT_TRIGGER);
        return new PadState(
                down,
                state.axes(GLFW_GAMEPAD_AXIS_LEFT_X),
                state.axes(GLFW_GAMEPAD_AXIS_LEFT_Y),
                state.axes(GLFW_GAMEPAD_AXIS_RIGHT_X),
                state.axes(GLFW_GAMEPAD_AXIS_RIGHT_Y));
    }

    /** A trigger's axis runs from −1 to 1. */
    private void addIfPulled(EnumSet<PadButton> down, PadButton trigger, int axis) {
        if ((state.axes(axis) + 1) / 2 > Gamepad.PRESSED) {
            down.add(trigger);
        }
    }

    @Override
    public void close() {
        state.free();
    }
}
