package nephele.app.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.app.window.Control;
import nephele.app.window.Input;
import org.junit.jupiter.api.Test;
import org.lwjgl.glfw.GLFW;

class WipeControlTest {
    private final Input input = new Input();
    private final WipeControl control = new WipeControl(input);

    private void tap(int key) {
        input.key(key, true);
        input.key(key, false);
        control.update(0);
    }

    @Test
    void theArrowsMoveTheWipeAndDoNotWalk() {
        control.update(0);
        input.key(GLFW.GLFW_KEY_LEFT, true);
        assertFalse(input.holds(Control.LEFT));
        control.update(0.05);
        assertEquals(0.5 - 0.02 - 0.4 * 0.05, control.wipe().fraction(), 1e-12);
        input.key(GLFW.GLFW_KEY_LEFT, false);
        control.update(0.05);
        assertEquals(0.46, control.wipe().fraction(), 1e-12);
        control.rest();
        input.key(GLFW.GLFW_KEY_LEFT, true);
        assertTrue(input.holds(Control.LEFT), "in a level without a comparison the arrow walks");
    }

    @Test
    void shiftIsFinerAndHomeAndEndShowOneSide() {
        control.update(0);
        input.key(GLFW.GLFW_KEY_LEFT_SHIFT, true);
        tap(GLFW.GLFW_KEY_RIGHT);
        assertEquals(0.502, control.wipe().fraction(), 1e-12);
        tap(GLFW.GLFW_KEY_HOME);
        assertEquals(0, control.wipe().fraction());
        tap(GLFW.GLFW_KEY_LEFT);
        assertEquals(0, control.wipe().fraction());
        tap(GLFW.GLFW_KEY_END);
        assertEquals(1, control.wipe().fraction());
    }

    @Test
    void anArrowThatWasHeldBeforeDoesNotWalkForEver() {
        input.key(GLFW.GLFW_KEY_LEFT, true);
        control.update(0);
        input.key(GLFW.GLFW_KEY_LEFT, false);
        assertFalse(input.holds(Control.LEFT));
    }
}
