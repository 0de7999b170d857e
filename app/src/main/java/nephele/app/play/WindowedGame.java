package nephele.app.play;

import java.io.PrintStream;
import nephele.app.settings.Settings;
import nephele.app.window.GameWindow;
import nephele.app.window.Input;
import nephele.app.window.WindowMode;
import nephele.engine.render.gl.GlContext;

/** The game in a window of its own. */
public final class WindowedGame {

    private final PlayRequest request;

    public WindowedGame(PlayRequest request) {
        this.request = request;
    }

    /** Plays until the player quits. @param shown is called when the level is loaded */
    public void run(Runnable shown) {
        var input = new Input();
        try (var window = open(input);
                var gl = GlContext.ofCurrent();
                var loop = new GameLoop(request, window, gl, input)) {
            shown.run();
            loop.run();
        }
    }

    /** Draws only the first frame and reports the time of each part of the start. */
    public void profileStart(StartProfile profile, PrintStream out) {
        profile.done("arguments");
        var input = new Input();
        try (var window = open(input);
                var gl = GlContext.ofCurrent()) {
            profile.done("window and context");
            try (var loop = new GameLoop(request, window, gl, input)) {
                loop.frame();
                gl.finish();
                profile.done("level, upload, compile and first frame");
                profile.report().forEach(out::println);
            }
        }
    }

    private GameWindow open(Input input) {
        System.setProperty("java.awt.headless", "true"); // ImageIO writes pictures and must not open a display
        var picture = request.picture();
        var window = GameWindow.open(new GameWindow.Request(GameLoop.TITLE, picture.width(), picture.height()), input);
        if (picture.fullScreen()) {
            window.become(
                    WindowMode.FULLSCREEN,
                    Settings.resolution(request.player().files().settings()));
        }
        return window;
    }
}
