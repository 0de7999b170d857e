package nephele.app.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import nephele.app.window.Gamepad.Use;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.lwjgl.glfw.GLFW;

/** Buttons and sticks of a pad become controls, walking and turning. */
class GamepadTest {
    private static final double FRAME_SECONDS = 0.02;

    private final Input input = new Input();
    private final Gamepad gamepad = new Gamepad(input);

    private static PadState pressed(PadButton... buttons) {
        return new PadState(Set.of(buttons), 0, 0, 0, 0);
    }

    private static PadState left(double x, double y) {
        return new PadState(Set.of(), x, y, 0, 0);
    }

    private static PadState right(double x, double y) {
        return new PadState(Set.of(), 0, 0, x, y);
    }

    private void hold(PadState state, Use use, int frames) {
        for (int i = 0; i < frames; i++) {
            gamepad.update(state, use, FRAME_SECONDS);
        }
    }

    private List<Control> taken() {
        List<Control> all = new ArrayList<>();
        for (Control next = input.nextPressed(); next != null; next = input.nextPressed()) {
            all.add(next);
        }
        return all;
    }

    /** The enum's first constants are GLFW's buttons by their numbers. */
    @Test
    void buttonsAreInTheOrderOfGlfw() {
        assertEquals(GLFW.GLFW_GAMEPAD_BUTTON_A, PadButton.A.ordinal());
        assertEquals(GLFW.GLFW_GAMEPAD_BUTTON_START, PadButton.START.ordinal());
        assertEquals(GLFW.GLFW_GAMEPAD_BUTTON_RIGHT_THUMB, PadButton.R3.ordinal());
        assertEquals(GLFW.GLFW_GAMEPAD_BUTTON_DPAD_LEFT, PadButton.LEFT.ordinal());
        assertEquals(GLFW.GLFW_GAMEPAD_BUTTON_LAST, PadButton.LEFT.ordinal());
    }

    @Test
    void aButtonIsHeldUntilItIsReleased() {
        hold(pressed(PadButton.RT), Use.PLAY, 3);
        assertTrue(input.holds(Control.FIRE_FIRST));
        hold(PadState.RELEASED, Use.PLAY, 1);
        assertFalse(input.holds(Control.FIRE_FIRST));
        assertEquals(List.of(Control.FIRE_FIRST), taken());
    }

    /** The button that continues the game does not jump, and releases what it pressed. */
    @Test
    void aButtonKeepsItsMeaningUntilItIsReleased() {
        hold(pressed(PadButton.A), Use.MENU, 2);
        assertEquals(List.of(Control.CONFIRM), taken());
        hold(pressed(PadButton.A), Use.PLAY, 5);
        assertFalse(input.holds(Control.JUMP));
        hold(PadState.RELEASED, Use.PLAY, 1);
        assertFalse(input.holds(Control.CONFIRM));
        hold(pressed(PadButton.A), Use.PLAY, 1);
        assertTrue(input.holds(Control.JUMP));
    }

    @Test
    void stickAndDpadRepeatInMenus() {
        int frames = (int) Math.ceil((Gamepad.FIRST_REPEAT_SECONDS + 2.5 * Gamepad.REPEAT_SECONDS) / FRAME_SECONDS);
        hold(left(0.1, 0.9), Use.MENU, frames);
        assertEquals(List.of(Control.BACK, Control.BACK, Control.BACK, Control.BACK), taken());
        hold(PadState.RELEASED, Use.MENU, 50);
        assertEquals(List.of(), taken());
        hold(pressed(PadButton.UP), Use.MENU, 1);
        assertEquals(List.of(Control.FORWARD), taken());
    }

    @Test
    void theStickWalksByDegreesAndNotByKeys() {
        hold(left(0, -0.6), Use.PLAY, 1);
        double share = (0.6 - Gamepad.DEAD_ZONE) / (1 - Gamepad.DEAD_ZONE);
        assertEquals(share, input.walkForward(), 1e-12);
        assertEquals(0, input.walkRight(), 1e-12);
        assertEquals(List.of(), taken());
        hold(left(1, 1), Use.PLAY, 1);
        assertEquals(1, Math.hypot(input.walkForward(), input.walkRight()), 1e-12);
        assertTrue(input.walkForward() < 0 && input.walkRight() > 0);
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 0.1, 0.17})
    void aStickAtRestDoesNothing(double drift) {
        hold(new PadState(Set.of(), drift, 0, 0, -drift), Use.PLAY, 100);
        assertEquals(0, input.walkRight());
        assertEquals(0, input.takeCountsRight());
        assertEquals(Input.Device.KEYBOARD, input.device());
    }

    /** The same turn in a second at every frame rate. */
    @Test
    void theTurnDoesNotDependOnTheFrameRate() {
        for (int i = 0; i < 10; i++) {
            gamepad.update(right(0.8, -0.2), Use.PLAY, 0.1);
        }
        double slow = input.takeCountsRight();
        double slowDown = input.takeCountsDown();
        for (int i = 0; i < 200; i++) {
            gamepad.update(right(0.8, -0.2), Use.PLAY, 0.005);
        }
        assertEquals(slow, input.takeCountsRight(), 1e-9);
        assertEquals(slowDown, input.takeCountsDown(), 1e-9);
        assertTrue(slow > 500 && slowDown < 0, slow + ", " + slowDown);
    }

    @Test
    void thePadCancelsTheChoiceOfAKey() {
        input.capture();
        hold(pressed(PadButton.A), Use.MENU, 1);
        assertTrue(input.isCapturing());
        assertNull(input.takeCaptured());
        hold(pressed(PadButton.B), Use.MENU, 1);
        assertEquals(KeyNames.code("Escape"), input.takeCaptured());
        assertEquals(Input.Device.GAMEPAD, input.device());
    }

    @Test
    void theDeviceIsTheOneThatWasUsedLast() {
        hold(pressed(PadButton.X), Use.PLAY, 1);
        assertEquals(Input.Device.GAMEPAD, input.device());
        input.key(KeyNames.code("W"), true);
        assertEquals(Input.Device.KEYBOARD, input.device());
        hold(left(1, 0), Use.PLAY, 1);
        assertEquals(Input.Device.GAMEPAD, input.device());
    }
}
