package nephele.app.play;

import java.util.Set;
import nephele.app.play.hud.Menu;
import nephele.app.settings.GameSetting;
import nephele.app.settings.PlayerFiles;
import nephele.app.settings.Settings;
import nephele.app.settings.Settings.Switch;
import nephele.app.settings.Settings.WindowMode;
import nephele.app.text.Phrase;
import nephele.app.window.GameWindow;
import nephele.engine.render.gl.GlContext;

/** Changes settings from the menu, keeps them, and applies them at once to window and level. */
final class SettingsControl {
    /** Settings of the simulation, which a running level keeps: its recording states them once. */
    private static final Set<GameSetting<?>> FROM_NEXT_START =
            Set.of(Settings.ASSISTS, Settings.UPRIGHT, Settings.REDUCED_MOTION);

    private final GameWindow window;
    private final GlContext gl;
    private final PlayerFiles files;
    private final GameMenus menus;
    private final MenuControl menu;
    private final CurrentLevel current;
    private final Message message;

    SettingsControl(
            GameWindow window, GlContext gl, GameMenus menus, MenuControl menu, CurrentLevel current, Message message) {
        this.window = window;
        this.gl = gl;
        this.menus = menus;
        this.menu = menu;
        this.current = current;
        this.message = message;
        files = menus.files();
    }

    /** Changes a setting; the settings page is open. */
    void change(Menu.Choice.Step step) {
        files.keep(files.settings().stepped(step.setting(), step.step()));
        menu.rewrite(menus.page(Menu.Page.SETTINGS));
        if (FROM_NEXT_START.contains(step.setting())) {
            message.say(Phrase.FROM_NEXT_START.in(menus.language()));
        }
        applyToWindow();
        if (current.session() != null) {
            current.session().apply();
            if (step.setting().equals(Settings.QUALITY)) {
                current.redraw(gl);
            }
        }
    }

    /** Changes the kind of window and keeps it as a setting. */
    void toggleFullScreen() {
        window.toggleFullScreen();
        files.keep(files.settings()
                .with(Settings.WINDOW_MODE, window.isFullScreen() ? WindowMode.FULLSCREEN : WindowMode.WINDOWED));
        if (menu.page() != null && menu.page().name().equals("settings")) {
            menu.rewrite(menus.page(Menu.Page.SETTINGS));
        }
    }

    /** Applies the settings of the window. */
    void applyToWindow() {
        if (window.isFullScreen() != (files.settings().get(Settings.WINDOW_MODE) == WindowMode.FULLSCREEN)) {
            window.toggleFullScreen();
        }
        window.verticalSync(files.settings().get(Settings.VERTICAL_SYNC) == Switch.ON);
    }
}
