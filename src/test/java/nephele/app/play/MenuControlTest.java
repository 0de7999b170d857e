package nephele.app.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNull;

import nephele.app.play.hud.Area;
import nephele.app.play.hud.Menu;
import nephele.app.window.Control;
import nephele.app.window.Input;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class MenuControlTest {
    private static final Area AREA = new Area(1280, 720);
    private final MenuControl control = new MenuControl();
    private final Input input = new Input();

    @BeforeEach
    void open() {
        control.open();
    }

    @Test
    void enterChoosesWhatTheArrowsSelected() {
        assertNull(control.choiceOf(Control.BACK));
        assertInstanceOf(Menu.Choice.Restart.class, control.choiceOf(Control.CONFIRM));
    }

    @Test
    void escapeContinues() {
        assertInstanceOf(Menu.Choice.Continue.class, control.choiceOf(Control.MENU));
    }

    @Test
    void theListOfLevelsStartsOneAndLeadsBack() {
        control.choiceOf(Control.BACK);
        control.choiceOf(Control.BACK);
        assertNull(control.choiceOf(Control.CONFIRM));
        var start = assertInstanceOf(Menu.Choice.Start.class, control.choiceOf(Control.CONFIRM));
        assertEquals("Courtyard", start.level().title());
        control.choiceOf(Control.FORWARD);
        assertNull(control.choiceOf(Control.CONFIRM));
        assertEquals("Nephele", control.page().title());
    }

    /** Every pixel row down the middle: entries in their order, each as high as the others, nothing beside them. */
    @Test
    void aClickChoosesTheRowUnderIt() {
        int quits = 0;
        int continues = 0;
        for (int y = 0; y < 720; y++) {
            control.open();
            input.point(2 * 640, 2 * y);
            input.click();
            var choice = control.choiceOf(input, AREA, 2);
            quits += choice instanceof Menu.Choice.Quit ? 1 : 0;
            continues += choice instanceof Menu.Choice.Continue ? 1 : 0;
        }
        assertEquals(46, quits, 1);
        assertEquals(46, continues, 1);
    }

    @Test
    void aClickBesideTheMenuChoosesNothing() {
        input.point(10, 360);
        input.click();
        assertNull(control.choiceOf(input, AREA, 1));
        assertEquals(0, control.page().selected());
    }
}
