package nephele.app.play;

import java.util.Set;
import nephele.app.play.hud.Menu;
import nephele.app.settings.GameSetting;
import nephele.app.settings.Phrase;
import nephele.app.settings.PlayerFiles;
import nephele.app.settings.Settings;
import nephele.app.settings.Settings.Switch;
import nephele.app.window.Control;
import nephele.app.window.GameWindow;
import nephele.app.window.Input;
import nephele.app.window.KeyNames;
import nephele.app.window.WindowMode;

/** Changes settings from the menu, keeps them, and applies them at once to window and level. */
final class SettingsControl {
    /** Settings of the simulation, which a running level keeps: its recording states them once. */
    private static final Set<GameSetting<?>> FROM_NEXT_START =
            Set.of(Settings.ASSISTS, Settings.UPRIGHT, Settings.REDUCED_MOTION);

    /** Settings of the picture, for which the level is drawn anew. */
    private static final Set<GameSetting<?>> REDRAWN = Set.of(Settings.QUALITY, Settings.ANTIALIASING);

    private static final Set<GameSetting<?>> OF_WINDOW = Set.of(Settings.WINDOW_MODE, Settings.RESOLUTION);

    private final GameWindow window;
    private final Input input;
    private final PlayerFiles files;
    private final GameMenus menus;
    private final MenuControl menu;
    private final CurrentLevel current;
    private final Message message;
    private Control awaited;

    SettingsControl(
            GameWindow window, Input input, GameMenus menus, MenuControl menu, CurrentLevel current, Message message) {
        this.window = window;
        this.input = input;
        this.menus = menus;
        this.menu = menu;
        this.current = current;
        this.message = message;
        files = menus.files();
        input.bind(Settings.bindings(files.settings()));
    }

    /** Changes a setting; the page on which it stands is open. */
    void change(Menu.Choice.Step step) {
        files.keep(files.settings().stepped(step.setting(), step.step()));
        menu.rewrite(menus.pageOf(step.setting()));
        if (FROM_NEXT_START.contains(step.setting())) {
            message.say(Phrase.FROM_NEXT_START);
        }
        if (OF_WINDOW.contains(step.setting())) {
            applyMode();
        }
        applyVerticalSync();
        if (current.session() != null) {
            current.session().apply();
            if (REDRAWN.contains(step.setting())) {
                current.redraw();
            }
        }
    }

    /** Waits for a key of a control; the page of keys is open. */
    void awaitKey(Control control) {
        awaited = control;
        input.capture();
        menu.rewrite(menus.keys(control));
    }

    /** Binds the awaited key when it comes; Esc leaves the keys as they are. */
    void obeyCapturedKey() {
        Integer code = input.takeCaptured();
        if (code == null || awaited == null) {
            return;
        }
        String key = KeyNames.name(code);
        if (key == null) {
            message.say(Phrase.UNNAMED_KEY);
        } else if (!key.equals("Escape")) {
            var bindings = Settings.bindings(files.settings());
            files.keep(files.settings().with(Settings.KEYS.get(awaited), bindings.replaced(awaited, key)));
            input.bind(Settings.bindings(files.settings()));
        }
        awaited = null;
        menu.rewrite(menus.keys(null));
    }

    /** Changes the kind of window and keeps it as a setting. */
    void toggleFullScreen() {
        WindowMode next = window.mode() == WindowMode.WINDOWED ? WindowMode.FULLSCREEN : WindowMode.WINDOWED;
        files.keep(files.settings().with(Settings.WINDOW_MODE, next));
        applyMode();
        Menu changed = menus.pageOf(Settings.WINDOW_MODE);
        if (menu.page() != null && menu.page().name().equals(changed.name())) {
            menu.rewrite(changed);
        }
    }

    /** Applies the kind of the window and its size. */
    void applyMode() {
        window.become(files.settings().get(Settings.WINDOW_MODE), Settings.resolution(files.settings()));
    }

    void applyVerticalSync() {
        window.verticalSync(files.settings().get(Settings.VERTICAL_SYNC) == Switch.ON);
    }
}
