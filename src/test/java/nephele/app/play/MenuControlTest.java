package nephele.app.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNull;

import nephele.app.play.hud.Area;
import nephele.app.play.hud.Menu;
import nephele.app.play.hud.MenuPanel;
import nephele.app.play.hud.SettingsPage;
import nephele.app.window.Control;
import nephele.app.window.Input;
import nephele.engine.sim.state.SimSettings;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class MenuControlTest {
    private static final Area AREA = new Area(1280, 720);
    private final Input input = new Input();
    private final MenuControl control = new MenuControl(input);

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

    /** Clicks on every pixel row in the middle choose the entry below them: each entry has the same height. */
    @Test
    void aClickChoosesTheRowUnderIt() {
        int quits = 0;
        int continues = 0;
        for (int y = 0; y < 720; y++) {
            control.open();
            input.point(2 * 640, 2 * y);
            input.click();
            var choice = control.choiceOf(AREA, 2);
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
        assertNull(control.choiceOf(AREA, 1));
        assertEquals(0, control.page().selected());
    }

    /** The system puts a released pointer back to an arbitrary place; a click there chooses nothing. */
    @Test
    void aClickBeforeThePointerMovesChoosesNothing() {
        for (int y = 0; y < 720; y++) {
            input.point(640, y);
            control.open();
            input.click();
            assertNull(control.choiceOf(AREA, 1), "y " + y);
            assertEquals("Nephele", control.page().title());
        }
    }

    /** A click before the pointer moves selects the entry that the next click chooses. */
    @Test
    void thatClickShowsWhatTheNextOneChooses() {
        input.point(640, row(5));
        control.open();
        input.click();
        assertNull(control.choiceOf(AREA, 1));
        assertInstanceOf(Menu.Choice.Quit.class, control.page().chosen());
        input.click();
        assertInstanceOf(Menu.Choice.Quit.class, control.choiceOf(AREA, 1));
    }

    /** A double click on an entry that opens a page chooses nothing on that page. */
    @Test
    void aClickThatTurnsThePageDoesNotGoOnThere() {
        input.point(640, row(3));
        input.click();
        assertNull(control.choiceOf(AREA, 1));
        assertEquals("Choose a level", control.page().title());
        input.click();
        assertNull(control.choiceOf(AREA, 1));
        assertEquals("Choose a level", control.page().title());
    }

    /** In a slow frame the pointer may move after a click; the click counts where the button went down. */
    @Test
    void aClickMeansTheRowWhereTheButtonWentDown() {
        input.point(640, row(1));
        input.click();
        input.point(640, row(5));
        assertInstanceOf(Menu.Choice.Continue.class, control.choiceOf(AREA, 1));
    }

    @Test
    void escapeLeadsFromEveryOtherPageBack() {
        input.point(640, row(3));
        input.click();
        control.choiceOf(AREA, 1);
        assertNull(control.choiceOf(Control.MENU));
        assertEquals("Nephele", control.page().title());
        control.turnTo(SettingsPage.of(SimSettings.DEFAULT));
        assertNull(control.choiceOf(Control.MENU));
        assertEquals("Nephele", control.page().title());
        assertInstanceOf(Menu.Choice.Continue.class, control.choiceOf(Control.MENU));
    }

    /** Returns the middle of a row of the pause menu, counted from 1. */
    private static double row(int number) {
        int rows = Menu.pause().entries().size();
        int y = 0;
        while (new MenuPanel(Menu.pause(), AREA).rowAt(640, y) < 0) {
            y++;
        }
        assertEquals(5, rows);
        return y + 46 * (number - 0.5);
    }
}
