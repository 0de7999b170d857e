package nephele.app.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.EnumMap;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.lwjgl.glfw.GLFW;

class InputTest {
    private final Input input = new Input();

    @Test
    void theFirstMotionOnlySaysWhereTheMouseIs() {
        input.look(5000, -3000);
        assertEquals(0, input.takeCountsRight());
        input.look(5003, -3004);
        assertEquals(3, input.takeCountsRight());
        assertEquals(-4, input.takeCountsDown());
    }

    @Test
    void aRegainedFocusDoesNotTurnTheView() {
        input.look(0, 0);
        input.forget();
        input.look(900, 900);
        assertEquals(0, input.takeCountsRight());
        assertEquals(0, input.takeCountsDown());
    }

    @Test
    void manySmallMotionsTurnAsFarAsOneLargeOne() {
        input.look(0, 0);
        for (int i = 1; i <= 1000; i++) {
            input.look(i * 0.5, i * 0.25);
        }
        assertEquals(500, input.takeCountsRight());
        assertEquals(250, input.takeCountsDown());
        assertEquals(0, input.takeCountsRight());
    }

    @Test
    void aLostFocusReleasesEveryKey() {
        input.key(GLFW.GLFW_KEY_W, true);
        input.key(GLFW.GLFW_KEY_SPACE, true);
        assertTrue(input.holds(Control.FORWARD));
        input.forget();
        assertFalse(input.holds(Control.FORWARD));
        assertFalse(input.holds(Control.JUMP));
        assertNull(input.nextPressed());
    }

    /** Keys pressed while the menu closes are kept for the game. */
    @Test
    void aMouseThatChangesHandsKeepsTheKeys() {
        input.look(0, 0);
        input.look(5, 5);
        input.click();
        input.key(Control.FORWARD, true);
        input.key(Control.RESTART, true);
        input.forgetMouse();
        input.look(900, 900);
        assertEquals(0, input.takeCountsRight());
        assertNull(input.takeClick());
        assertTrue(input.holds(Control.FORWARD));
        assertEquals(Control.FORWARD, input.nextPressed());
        assertEquals(Control.RESTART, input.nextPressed());
    }

    @Test
    void pressesArriveInOrderAndOnce() {
        input.key(GLFW.GLFW_KEY_F3, true);
        input.key(GLFW.GLFW_KEY_F3, false);
        input.key(GLFW.GLFW_KEY_ESCAPE, true);
        assertEquals(Control.FIGURES, input.nextPressed());
        assertEquals(Control.MENU, input.nextPressed());
        assertNull(input.nextPressed());
    }

    @Test
    void aKeyThatMeansNothingIsIgnored() {
        input.key(GLFW.GLFW_KEY_F25, true);
        input.key(GLFW.GLFW_KEY_UNKNOWN, true);
        assertNull(input.nextPressed());
    }

    @Test
    void aFloodOfKeysDoesNotFillTheMemory() {
        for (int i = 0; i < 10_000; i++) {
            input.key(GLFW.GLFW_KEY_F3, true);
        }
        int waiting = 0;
        while (input.nextPressed() != null) {
            waiting++;
        }
        assertEquals(64, waiting);
    }

    /**
     * A press and release between two ticks is reported once, as a slow frame has several ticks and a fast one none.
     */
    @Test
    void aShortPressIsToldOnce() {
        input.key(InputListener.MOUSE + GLFW.GLFW_MOUSE_BUTTON_RIGHT, true);
        input.key(InputListener.MOUSE + GLFW.GLFW_MOUSE_BUTTON_RIGHT, false);
        assertFalse(input.holds(Control.FIRE_SECOND));
        assertFalse(input.takeHold(Control.FIRE_FIRST));
        assertTrue(input.takeHold(Control.FIRE_SECOND));
        assertFalse(input.takeHold(Control.FIRE_SECOND));
        input.key(GLFW.GLFW_KEY_E, true);
        assertTrue(input.takeHold(Control.CARRY));
        assertTrue(input.takeHold(Control.CARRY));
        input.key(GLFW.GLFW_KEY_E, false);
        assertFalse(input.takeHold(Control.CARRY));
    }

    @Test
    void aMouseThatChangesHandsHoldsNoButton() {
        input.key(InputListener.MOUSE + GLFW.GLFW_MOUSE_BUTTON_LEFT, true);
        input.forgetMouse();
        assertFalse(input.takeHold(Control.FIRE_FIRST));
    }

    /** The first click of a released pointer that has not moved only points; the next one clicks. */
    @Test
    void aPointerThatNobodyMovedDoesNotClick() {
        input.point(30, 40);
        input.forgetMouse();
        input.click();
        assertNull(input.takeClick());
        assertTrue(input.takePointerMoved());
        input.click();
        assertEquals(new Input.Click(30, 40), input.takeClick());
        assertNull(input.takeClick());
    }

    @Test
    void aClickStaysWhereTheButtonWentDown() {
        input.point(30, 40);
        input.click();
        input.point(300, 400);
        assertEquals(new Input.Click(30, 40), input.takeClick());
    }

    /**
     * A mouse that is released keeps its pointer's position and reports no motion, so that the menu's first row stays
     * selected.
     */
    @Test
    void aMouseThatChangesHandsLeavesThePointerWhereItLies() {
        input.point(30, 40);
        input.forgetMouse();
        assertEquals(30, input.pointerX());
        assertEquals(40, input.pointerY());
        assertFalse(input.takePointerMoved());
    }

    @Test
    void aBoundKeyReplacesTheUsualOne() {
        var keys = new EnumMap<Control, List<String>>(Control.class);
        keys.put(Control.JUMP, List.of("J"));
        keys.put(Control.CARRY, List.of("J"));
        input.bind(KeyBindings.of(keys));
        input.key(GLFW.GLFW_KEY_SPACE, true);
        assertFalse(input.holds(Control.JUMP));
        input.key(GLFW.GLFW_KEY_J, true);
        assertTrue(input.holds(Control.JUMP));
        assertTrue(input.holds(Control.CARRY));
    }

    @Test
    void aCapturedKeyDoesNothingElse() {
        input.capture();
        input.key(GLFW.GLFW_KEY_W, false);
        input.key(GLFW.GLFW_KEY_W, true);
        assertFalse(input.holds(Control.FORWARD));
        assertEquals(GLFW.GLFW_KEY_W, input.takeCaptured());
        assertNull(input.takeCaptured());
        input.key(GLFW.GLFW_KEY_W, true);
        assertTrue(input.holds(Control.FORWARD));
    }

    @Test
    void everyNameHasACodeOfItsOwn() {
        for (Control control : Control.values()) {
            for (String name : control.usualKeys()) {
                assertEquals(name, KeyNames.name(KeyNames.code(name)));
            }
        }
        assertEquals("Mouse 1", KeyNames.name(InputListener.MOUSE));
        assertNull(KeyNames.name(-1));
    }
}
