package nephele.app.play.hud;

import java.util.List;
import nephele.engine.render.pass.overlay.Lettering;
import nephele.engine.render.pass.overlay.OverlayCanvas;

/** Updates the overlay's canvas; fills it again only when content, size or scale have changed. */
public final class Hud {
    private final OverlayCanvas canvas;
    private HudContent shown;
    private Area shownArea;
    private double shownScale;

    public Hud(Lettering lettering) {
        canvas = new OverlayCanvas(lettering);
    }

    /** Returns the canvas for this content on a picture of this size. */
    public OverlayCanvas canvas(HudContent content, Area area, double pixelsPerPoint) {
        if (!content.equals(shown) || !area.equals(shownArea) || pixelsPerPoint != shownScale) {
            shown = content;
            shownArea = area;
            shownScale = pixelsPerPoint;
            canvas.begin(pixelsPerPoint);
            fill(content, area);
        }
        return canvas;
    }

    private void fill(HudContent content, Area area) {
        if (content.comparison() != null && content.menu() == null && content.page() == HudContent.Page.NONE) {
            new WipeLine(canvas, area, content.comparison()).draw(content.sight());
        }
        if (content.menu() != null) {
            drawMenu(content, area);
        } else if (content.page() == HudContent.Page.HELP) {
            HelpPanel.draw(canvas, area, content.keys(), HelpPanel.rows(content));
        } else if (content.sight() != null) {
            Crosshair.draw(canvas, area, content.sight());
            if (content.sight().prompt() != null) {
                PromptLine.draw(canvas, area, content.sight().prompt());
            }
        }
        if (content.banner() != null && content.menu() == null && content.page() == HudContent.Page.NONE) {
            BannerPanel.draw(canvas, area, content.banner());
        }
        if (!content.figures().isEmpty() && content.menu() == null) {
            FrameStatisticsPanel.draw(canvas, area, content.figures());
        }
        if (!content.messages().isEmpty() && content.menu() == null) {
            new MessageBar(canvas, area, content.messages()).draw(canvas);
        }
    }

    /** Draws a menu with the messages below it, or with the latest one in its foot if there is no room. */
    private void drawMenu(HudContent content, Area area) {
        MenuPanel panel = new MenuPanel(content.menu(), area);
        List<String> messages = content.messages();
        if (messages.isEmpty()) {
            panel.draw(canvas);
            return;
        }
        MessageBar bar = new MessageBar(canvas, area, messages);
        if (bar.top() >= panel.bottom()) {
            panel.draw(canvas);
            bar.draw(canvas);
        } else {
            panel.draw(canvas, messages.get(messages.size() - 1), HudPalette.INK);
        }
    }
}
