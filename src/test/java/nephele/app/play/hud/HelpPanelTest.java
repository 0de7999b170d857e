package nephele.app.play.hud;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import nephele.app.window.Control;
import nephele.app.window.Input;
import nephele.app.window.KeyBindings;
import nephele.engine.level.Language;
import nephele.engine.render.pass.overlay.FontAtlas;
import nephele.engine.render.pass.overlay.OverlayCanvas;
import org.junit.jupiter.api.Test;

/** The F1 page shows every key, whatever the window's size. */
final class HelpPanelTest {
    @Test
    void pageFitsIntoLowWindows() {
        for (double height : new double[] {360, 540, 720}) {
            var area = new Area(16 * height / 9, height);
            int rows = HelpPanel.ROWS;
            Box box = HelpPanel.box(area, Box.of(area), rows);
            assertTrue(box.top() >= 0 && box.bottom() <= height + 1e-9, height + ": " + box);
        }
        assertEquals(1, HelpPanel.scale(new Box(0, 0, 1280, 720), HelpPanel.ROWS));
    }

    @Test
    void keysFitIntoTheirColumnAndMeaningsIntoThePage() {
        var canvas = new OverlayCanvas(new FontAtlas());
        for (var device : Input.Device.values()) {
            for (var language : Language.values()) {
                var shown = new HudContent.Keys(KeyBindings.usual(), device, language);
                for (var control : Control.values()) {
                    double keys = canvas.width(HelpPanel.EM, shown.names(control));
                    double meaning = canvas.width(HelpPanel.EM, shown.meaning(control));
                    assertTrue(keys < HelpPanel.KEY_COLUMN - 4, control + ": " + keys);
                    assertTrue(
                            HelpPanel.PADDING + HelpPanel.KEY_COLUMN + meaning < HelpPanel.WIDTH,
                            control + ": " + meaning);
                }
            }
        }
    }
}
