package nephele.app.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import nephele.app.play.hud.Area;
import nephele.app.play.hud.Menu;
import nephele.app.play.hud.Menu.Choice;
import nephele.app.play.hud.MenuPanel;
import nephele.app.settings.GameSetting;
import nephele.app.settings.PlayerFiles;
import nephele.app.settings.Progress;
import nephele.app.settings.Settings;
import nephele.app.window.Control;
import nephele.app.window.Input;
import nephele.engine.level.Language;
import nephele.engine.level.PlayerStart;
import nephele.engine.math.Vec3;
import nephele.host.named.LevelCatalogue;
import nephele.host.named.LevelName;
import nephele.host.userfile.UserFolders;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Keys and pointer choose what is shown, and a page keeps its selection while another one is above it. */
class MenuControlTest {
    private static final Area AREA = new Area(1280, 720);
    private static final LevelName COURTYARD = new LevelName("levels/01-courtyard.json");
    private static final LevelName SHOT = new LevelName("levels/02-first-shot.json");

    private final PlayerFiles files = new PlayerFiles(new UserFolders(null, null, null));
    private final Input input = new Input();
    private long nanos = 1;
    private final GameMenus menus =
            new GameMenus(files, List.of(COURTYARD, SHOT), LevelCatalogue.titles(), input::device);
    private final MenuControl control = new MenuControl(input, () -> nanos);

    @BeforeEach
    void open() {
        control.open(menus.pause(COURTYARD, "Find the way."));
    }

    @Test
    void enterChoosesWhatTheArrowsSelected() {
        assertNull(control.choiceOf(Control.BACK));
        assertEquals(new Choice.Open(Menu.Page.RESTART_QUESTION), control.choiceOf(Control.CONFIRM));
    }

    @Test
    void aPlayerRestsSomeTimeAfterAKeyOrAMotionOfThePointer() {
        assertTrue(control.rests(), "who has not begun holds nothing up");
        control.choiceOf(Control.BACK);
        assertFalse(control.rests());
        nanos += MenuControl.REST_NANOS;
        assertTrue(control.rests());
        input.point(3, 4);
        control.choiceOf(AREA, 1);
        assertFalse(control.rests());
    }

    @Test
    void escapeContinues() {
        assertEquals(Choice.Plain.RESUME, control.choiceOf(Control.MENU));
    }

    @Test
    void aPageKeepsItsCursorWhileAnotherIsOpen() {
        control.choiceOf(Control.BACK);
        control.choiceOf(Control.BACK);
        control.turnTo(menus.page(Menu.Page.LEVELS));
        assertEquals(new Choice.Play(COURTYARD), control.choiceOf(Control.CONFIRM));
        assertEquals(Choice.Plain.BACK, control.choiceOf(Control.MENU));
        control.back();
        assertEquals(2, control.page().selected());
        control.back();
        assertEquals("pause", control.page().name());
    }

    @Test
    void arrowsStepASettingAndTheCursorStays() {
        control.turnTo(menus.page(Menu.Page.SETTINGS));
        assertEquals(new Choice.Step(Settings.LANGUAGE, 1), control.choiceOf(Control.RIGHT));
        assertEquals(new Choice.Step(Settings.LANGUAGE, -1), control.choiceOf(Control.LEFT));
        control.choiceOf(Control.BACK);
        files.keep(files.settings().stepped(Settings.LANGUAGE, 1));
        control.rewrite(menus.page(Menu.Page.SETTINGS));
        control.rewriteFirst(menus.pause(COURTYARD, "Find the way."));
        assertEquals(1, control.page().selected());
        assertEquals("Configurações", control.page().title());
        control.back();
        assertEquals("Pausa", control.page().title());
    }

    @Test
    void theTitleBeginsAndThenContinues() {
        assertEquals("Begin", menus.title().entries().get(0).label());
        assertEquals(new Choice.Play(COURTYARD), menus.title().chosen());
        files.keep(files.progress().withFinished("01-courtyard.json", 3467, 0, 0));
        assertEquals("Continue", menus.title().entries().get(0).label());
        assertEquals(new Choice.Play(SHOT), menus.title().chosen());
        files.keep(files.progress().withFinished("02-first-shot.json", 1790, 2, 0));
        assertEquals(new Choice.Play(COURTYARD), menus.title().chosen());
    }

    /** Title, pause, list and end call a level by its title in the player's language. */
    @Test
    void everyPageNamesALevelInThePlayersLanguage() {
        files.keep(files.settings().with(Settings.LANGUAGE, Language.PT_PT));
        files.keep(files.progress().withFinished("01-courtyard.json", 3467, 0, 0));
        assertEquals("Primeiro disparo", menus.title().entries().get(0).value());
        assertEquals("Pátio", menus.pause(COURTYARD, null).lines().get(0));
        assertEquals("Pátio", menus.page(Menu.Page.LEVELS).entries().get(0).label());
        Menu ended = menus.ended(request(null), new FinishedRun(1790, 2, 0), Progress.NONE, Optional.of(COURTYARD));
        assertEquals("Primeiro disparo – Concluído", ended.title());
        assertEquals("Pátio", ended.entries().get(0).value());
    }

    @Test
    void theEndTellsTimePortalsAndBest() {
        Menu first = menus.ended(request(null), new FinishedRun(1790, 2, 0), Progress.NONE, Optional.empty());
        assertEquals(List.of("Time  0:14.92", "Portals  2", "You have finished every level."), first.lines());
        Progress before = Progress.NONE.withFinished("02-first-shot.json", 1200, 4, 0);
        Menu slower = menus.ended(request(null), new FinishedRun(1790, 2, 0), before, Optional.of(COURTYARD));
        assertEquals(List.of("Time  0:14.92", "Best  0:10.00", "Portals  2"), slower.lines());
        assertEquals(new Choice.Play(COURTYARD), slower.chosen());
    }

    /** A run that is not ranked is no best time, however fast, and the page says so. */
    @Test
    void theEndOfPracticeTellsNoRecord() {
        Progress before = Progress.NONE.withFinished("02-first-shot.json", 1200, 4, 0);
        PlayRequest practice = request(new PlayerStart(Vec3.ZERO, 0, 0));
        Menu faster = menus.ended(practice, new FinishedRun(600, 2, 0), before, Optional.of(COURTYARD));
        assertEquals(
                List.of("Time  0:05.00", "Best  0:10.00", "Portals  2", "Practice: no record is kept."),
                faster.lines());
    }

    private PlayRequest request(PlayerStart from) {
        var player = new PlayRequest.Player(files, null);
        return new PlayRequest(SHOT, from, null, null, null, null, null, null, player);
    }

    /** After a level that cannot be loaded the player is where it was chosen, not in another level's pause. */
    @Test
    void pagesOpenAgainAsTheyWere() {
        control.choiceOf(Control.BACK);
        control.choiceOf(Control.BACK);
        control.turnTo(menus.page(Menu.Page.LEVELS));
        control.choiceOf(Control.BACK);
        control.close();
        assertNull(control.page());
        control.reopen();
        assertEquals("levels", control.page().name());
        assertEquals(new Choice.Play(SHOT), control.choiceOf(Control.CONFIRM));
        control.back();
        assertEquals(2, control.page().selected());
    }

    /** The first page of a question leads back to the game, not to a page that was never open. */
    @Test
    void nothingIsBelowThePageThatWasOpenedFirst() {
        control.open(menus.page(Menu.Page.RESTART_QUESTION));
        assertEquals(Choice.Plain.BACK, control.choiceOf(Control.MENU));
        assertFalse(control.back());
        control.turnTo(menus.page(Menu.Page.LEVELS));
        assertTrue(control.back());
        assertEquals("restart-question", control.page().name());
    }

    /** Every phrase of every page exists in every language: the pages name settings and words by key. */
    @Test
    void allPagesExistInAllLanguages() {
        for (Language language : Language.values()) {
            files.keep(files.settings().with(Settings.LANGUAGE, language));
            for (int i = 0; i < 12; i++) {
                for (Menu.Page page : Menu.Page.values()) {
                    menus.page(page);
                }
                for (GameSetting.Group group : GameSetting.Group.values()) {
                    menus.settings(group);
                }
                for (var setting : Settings.PAGE.subList(1, Settings.PAGE.size())) {
                    files.keep(files.settings().stepped(setting, 1));
                }
            }
        }
    }

    /** Clicks on every pixel row in the middle choose the entry below them: each entry has the same height. */
    @Test
    void aClickChoosesTheRowUnderIt() {
        int quits = 0;
        int resumes = 0;
        for (int y = 0; y < 720; y++) {
            open();
            input.point(2 * 640, 2 * y);
            input.click();
            var choice = control.choiceOf(AREA, 2);
            quits += choice == Choice.Plain.QUIT ? 1 : 0;
            resumes += choice == Choice.Plain.RESUME ? 1 : 0;
        }
        assertEquals(44, quits, 1);
        assertEquals(44, resumes, 1);
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
            open();
            input.click();
            assertNull(control.choiceOf(AREA, 1), "y " + y);
        }
    }

    /** A click before the pointer moves selects the entry that the next click chooses. */
    @Test
    void thatClickShowsWhatTheNextOneChooses() {
        input.point(640, row(5));
        open();
        input.click();
        assertNull(control.choiceOf(AREA, 1));
        assertEquals(Choice.Plain.QUIT, control.page().chosen());
        input.click();
        assertEquals(Choice.Plain.QUIT, control.choiceOf(AREA, 1));
    }

    /** A page that opened by itself ignores keys and clicks for a while, and its first entry stays selected. */
    @Test
    void whatWasMeantForTheGameChoosesNothingAtTheEnd() {
        control.openUnasked(menus.pause(COURTYARD, "Find the way."));
        nanos += MenuControl.UNASKED_NANOS - 1;
        assertNull(control.choiceOf(Control.JUMP));
        assertNull(control.choiceOf(Control.BACK));
        input.point(640, row(5) - 1);
        input.point(640, row(5));
        input.click();
        assertNull(control.choiceOf(AREA, 1));
        assertEquals(0, control.page().selected());
        nanos++;
        assertNull(control.choiceOf(AREA, 1));
        assertEquals(0, control.page().selected());
        assertEquals(Choice.Plain.RESUME, control.choiceOf(Control.JUMP));
    }

    /** A page that the player opens obeys at once, also after one that has opened by itself. */
    @Test
    void aPageThatWasAskedForObeysAtOnce() {
        control.openUnasked(menus.page(Menu.Page.LEVELS));
        control.open(menus.pause(COURTYARD, "Find the way."));
        assertEquals(Choice.Plain.RESUME, control.choiceOf(Control.CONFIRM));
    }

    /** In a slow frame the pointer may move after a click; the click counts where the button went down. */
    @Test
    void aClickMeansTheRowWhereTheButtonWentDown() {
        input.point(640, row(0));
        input.click();
        input.point(640, row(5));
        assertEquals(Choice.Plain.RESUME, control.choiceOf(AREA, 1));
    }

    /** In a list that is longer than the window the pointer chooses what it was over before it selected it. */
    @Test
    void theListStaysUnderThePointerAndFollowsTheWheel() {
        Area low = new Area(640, 360);
        control.open(menus.page(Menu.Page.KEYS));
        int first = new MenuPanel(control.page(), low).rowAt(320, 100);
        for (int y = 100; y < 260; y++) {
            int row = new MenuPanel(control.page(), low).rowAt(320, y);
            input.point(320, y);
            assertNull(control.choiceOf(low, 1));
            assertEquals(row, control.page().selected(), "y " + y);
        }
        assertEquals(first, new MenuPanel(control.page(), low).rowAt(320, 100));
        input.scroll(-0.75);
        input.scroll(-1.5);
        assertNull(control.choiceOf(low, 1));
        assertEquals(first + 2, new MenuPanel(control.page(), low).rowAt(320, 100));
        input.scroll(-99);
        control.choiceOf(low, 1);
        int last = control.page().entries().size() - 1;
        int lastSeen = 0;
        for (int y = 100; y < 360; y++) {
            lastSeen = Math.max(lastSeen, new MenuPanel(control.page(), low).rowAt(320, y));
        }
        assertEquals(last, lastSeen);
    }

    /** With the mouse alone a number can be lowered as well as raised. */
    @Test
    void aClickOnTheLeftOfAValueStepsBack() {
        control.open(menus.settings(GameSetting.Group.VIEW));
        var panel = new MenuPanel(control.page(), AREA);
        int y = 0;
        while (panel.rowAt(640, y) != 0) {
            y++;
        }
        double right = 640 + 220 - 32;
        assertEquals(new Choice.Step(Settings.FIELD_OF_VIEW, 1), clicked(right - 4, y + 20));
        assertEquals(new Choice.Step(Settings.FIELD_OF_VIEW, -1), clicked(right - 55, y + 20));
        assertEquals(new Choice.Step(Settings.FIELD_OF_VIEW, 1), clicked(640, y + 20));
    }

    private Choice clicked(double x, double y) {
        input.point(x, y);
        input.click();
        return control.choiceOf(AREA, 1);
    }

    /** Returns the middle of a row of the pause menu, counted from 0. */
    private double row(int number) {
        MenuPanel panel = new MenuPanel(menus.pause(COURTYARD, "Find the way."), AREA);
        int y = 0;
        while (panel.rowAt(640, y) != number) {
            y++;
        }
        return y + 20;
    }

    @Test
    void aKeyOfTwoControlsIsShownAtBoth() {
        files.keep(files.settings().with(Settings.KEYS.get(Control.JUMP), List.of("E")));
        Menu keys = menus.keys(Control.RUN);
        assertEquals("E – also: pick up, let go", value(keys, "jump"));
        assertEquals("E – also: jump", value(keys, "pick up, let go"));
        assertEquals("press a key", value(keys, "run"));
        assertEquals("W, ↑", value(keys, "walk forward"));
    }

    private static String value(Menu menu, String label) {
        return menu.entries().stream()
                .filter(entry -> entry.label().equals(label))
                .findFirst()
                .orElseThrow()
                .value();
    }
}
