package nephele.app.view;

import nephele.app.play.hud.Area;
import nephele.app.window.GameWindow;
import nephele.engine.level.Language;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.RenderTarget;
import nephele.engine.render.pass.overlay.Lettering;
import nephele.engine.render.pass.overlay.OverlayCanvas;
import nephele.engine.render.pass.overlay.OverlayPass;

/**
 * The text over the picture. The key hints are shown at the start and on demand; messages are shown for three seconds.
 */
final class ViewerOverlay implements AutoCloseable {
    private static final double SHOWN_SECONDS = 10;
    private static final double FADE_SECONDS = 1;
    private static final double MESSAGE_SECONDS = 3;
    private static final int FADE_STEPS = 16;

    private final Lettering lettering = new Lettering();
    private final OverlayCanvas canvas = new OverlayCanvas(lettering);
    private final OverlayPass pass;
    private final KeyHints hints;
    private double hintSeconds = SHOWN_SECONDS + FADE_SECONDS;
    private double messageSeconds;
    private String message;
    private Content drawn;

    /** The values that the canvas depends on. */
    private record Content(String message, int opacity, int width, int height, double scale) {}

    ViewerOverlay(GlContext gl, Language language) {
        hints = new KeyHints(canvas, language);
        pass = new OverlayPass(gl, lettering);
    }

    void say(String words) {
        message = words;
        messageSeconds = MESSAGE_SECONDS;
    }

    /** Shows or hides the key hints; once requested they stay until hidden. */
    void toggleKeys() {
        hintSeconds = hintSeconds > 0 ? 0 : Double.POSITIVE_INFINITY;
    }

    void advance(double seconds) {
        hintSeconds = Math.max(0, hintSeconds - seconds);
        messageSeconds -= seconds;
        if (messageSeconds <= 0) {
            message = null;
        }
    }

    void draw(GameWindow window, RenderTarget target) {
        int opacity = (int) Math.ceil(FADE_STEPS * Math.min(1, hintSeconds / FADE_SECONDS));
        double scale = Area.pixelsPerPoint(target.width(), target.height(), window.scale());
        var content = new Content(message, opacity, target.width(), target.height(), scale);
        if (!content.equals(drawn)) {
            drawn = content;
            canvas.begin(content.scale);
            fill(content);
        }
        pass.draw(canvas, target);
    }

    private void fill(Content content) {
        double width = content.width / content.scale;
        double height = content.height / content.scale;
        hints.draw(width, height, (double) content.opacity / FADE_STEPS);
        if (content.message != null) {
            hints.say(width, content.message);
        }
    }

    @Override
    public void close() {
        pass.close();
    }
}
