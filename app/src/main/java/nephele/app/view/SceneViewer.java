package nephele.app.view;

import java.io.IOException;
import java.util.EnumSet;
import java.util.Optional;
import java.util.function.Consumer;
import nephele.app.play.PlayRequest.SceneViewing;
import nephele.app.settings.Phrase;
import nephele.app.window.GameWindow;
import nephele.app.window.PadButton;
import nephele.app.window.Screenshots;
import nephele.app.window.Size;
import nephele.app.window.WindowMode;
import nephele.engine.level.Language;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.RenderTarget;
import nephele.scenes.file.OpenedScene;
import nephele.scenes.file.SceneName;
import nephele.scenes.fixed.FixedSceneDrawing;
import nephele.scenes.fixed.LightTerm;
import nephele.scenes.fixed.SceneAppearance;
import nephele.scenes.view.SceneStart;
import nephele.scenes.view.ViewerKey;
import nephele.scenes.view.ViewerState;

/** The scene viewer in a window of its own. */
public final class SceneViewer implements AutoCloseable {
    private static final double HIDDEN_WAIT_SECONDS = 0.1;

    private final GameWindow window;
    private final Language language;
    private final ViewerInput input;
    private final GlContext gl;
    private final FixedSceneDrawing drawing;
    private final ViewerOverlay overlay;
    private final ViewerState viewing;
    private final Screenshots screenshots = Screenshots.inUsualFolder();
    private RenderTarget target;
    /** {@code null} before the first frame, so that loading time does not count as scene time. */
    private Long lastNanos;

    private boolean leaving;
    private boolean pictureAsked;

    SceneViewer(SceneStart start, GameWindow window, ViewerInput input, GlContext gl, Language language) {
        this.language = language;
        this.window = window;
        this.input = input;
        this.gl = gl;
        viewing = start.viewing();
        drawing = FixedSceneDrawing.load(gl, start.opened().sources());
        overlay = new ViewerOverlay(gl, language);
    }

    /**
     * Shows a scene until the user leaves.
     *
     * @param language of the hints
     */
    public static void show(SceneStart start, String title, Size size, Language language) {
        System.setProperty("java.awt.headless", "true"); // ImageIO writes pictures and must not open a display
        var input = new ViewerInput();
        try (var window = GameWindow.open(title, size, input);
                var gl = GlContext.ofCurrent();
                var viewer = new SceneViewer(start, window, input, gl, language)) {
            while (!viewer.isLeaving()) {
                viewer.frame();
            }
        }
    }

    /** Shows a scene in the window of the game until the user leaves, by key or by B or Start of a gamepad. */
    public static void visit(String file, String title, SceneViewing.Screen screen, Consumer<String> complaints) {
        var name = new SceneName(file);
        var start = new SceneStart(OpenedScene.ofGame(name, complaints), SceneAppearance.USUAL, 0);
        var window = screen.window();
        window.title(title);
        var input = new ViewerInput();
        window.captureMouse(false);
        window.listen(input);
        try (var viewer = new SceneViewer(start, window, input, screen.gl(), screen.language())) {
            boolean leavesByPad = false;
            // Until the button is up again: the menu would take it for one of its own.
            while (!viewer.isLeaving() && (!leavesByPad || isPadLeaving(window))) {
                viewer.frame();
                leavesByPad |= isPadLeaving(window);
            }
        } finally {
            window.listen(screen.own());
        }
    }

    private static boolean isPadLeaving(GameWindow window) {
        return window.pad().isDown(PadButton.B) || window.pad().isDown(PadButton.START);
    }

    /** Runs one frame. */
    void frame() {
        window.poll();
        if (!window.isDrawable()) {
            window.waitForEvents(HIDDEN_WAIT_SECONDS);
        }
        leaving |= window.closeRequested();
        obeyKeys();
        viewing.drag(input.takeDraggedRight() / window.scale(), input.takeDraggedDown() / window.scale());
        advance();
        if (window.isDrawable()) {
            draw();
        }
    }

    boolean isLeaving() {
        return leaving;
    }

    ViewerState viewing() {
        return viewing;
    }

    private void obeyKeys() {
        for (var key = input.nextPressed(); key != null; key = input.nextPressed()) {
            switch (key) {
                case LEAVE -> leaving = true;
                case FULL_SCREEN ->
                    window.become(
                            window.mode() == WindowMode.WINDOWED ? WindowMode.FULLSCREEN : WindowMode.WINDOWED, null);
                case SCREENSHOT -> pictureAsked = true;
                case KEYS -> overlay.toggleKeys();
                default -> {
                    viewing.press(key);
                    change(key, viewing, language).ifPresent(overlay::say);
                }
            }
        }
    }

    /** Returns in words what a key has changed, if the picture alone does not show it. */
    static Optional<String> change(ViewerKey key, ViewerState viewing, Language language) {
        return switch (key) {
            case PAUSE -> Optional.of((viewing.isPaused() ? Phrase.SCENE_RESTS : Phrase.SCENE_GOES_ON).in(language));
            case WIREFRAME, SHADING ->
                Optional.of(Phrase.SHADING_IS.in(
                        language, Phrase.ofWord(viewing.look().shading()).in(language)));
            case AMBIENT, DIFFUSE, SPECULAR, EMISSIVE ->
                Optional.of(Phrase.LIGHT_IS.in(language, termsInWords(viewing.look(), language)));
            default -> Optional.empty();
        };
    }

    private static String termsInWords(SceneAppearance look, Language language) {
        var words = EnumSet.allOf(LightTerm.class).stream()
                .filter(look.terms()::contains)
                .map(term -> Phrase.ofWord(term).in(language))
                .toList();
        return words.isEmpty() ? Phrase.WORD_NONE.in(language) : String.join(", ", words);
    }

    private void advance() {
        long now = System.nanoTime();
        double seconds = lastNanos == null ? 0 : (now - lastNanos) * 1e-9;
        lastNanos = now;
        viewing.advance(seconds, input.takeHeld());
        overlay.advance(seconds);
    }

    private void draw() {
        boolean fits = target != null && target.width() == window.width() && target.height() == window.height();
        if (!fits) {
            target = RenderTarget.window(gl, window.width(), window.height());
        }
        drawing.draw(
                viewing.view((double) target.width() / target.height()),
                viewing.sceneSeconds(),
                viewing.place().worldFromEntity(),
                viewing.look(),
                target);
        if (pictureAsked) {
            takePicture();
            pictureAsked = false;
        }
        overlay.draw(window, target);
        window.show();
    }

    private void takePicture() {
        try {
            overlay.say(Phrase.SAVED.in(language, screenshots.take(target)));
        } catch (IOException failure) {
            overlay.say(Phrase.NOT_SAVED.in(language, failure.getMessage()));
        }
    }

    @Override
    public void close() {
        overlay.close();
        drawing.close();
    }
}
