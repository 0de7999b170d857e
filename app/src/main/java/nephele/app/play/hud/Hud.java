package nephele.app.play.hud;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.render.pass.overlay.Lettering;
import nephele.engine.render.pass.overlay.OverlayCanvas;

/** Updates the overlay's canvas; fills it again only when content, size or scale have changed. */
public final class Hud {
    private static final double BESIDE_FIGURES = 8;

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
        if (content.page() == HudContent.Page.HELP && content.menu() != null) {
            canvas.rectangle(0, 0, area.width(), area.height(), HudPalette.VEIL);
        } else if (content.menu() != null) {
            drawMenu(content, area);
            return;
        } else if (content.page() == HudContent.Page.NONE && content.comparison() != null) {
            new WipeLine(canvas, area, Box.of(area), content.comparison()).drawLine(content.sight());
        }
        parts(content, area).forEach(part -> part.drawing.run());
    }

    /** A part of the overlay, and what draws it inside its box. */
    record Part(String name, Box box, Runnable drawing) {}

    /** Returns the parts of the overlay without those of a menu: none covers another. */
    List<Part> parts(HudContent content, Area area) {
        List<Part> parts = new ArrayList<>();
        Box room = Box.of(area);
        if (!content.figures().isEmpty() && content.menu() == null) {
            var panel = new FrameStatisticsPanel(area, content.figures());
            parts.add(new Part("figures", panel.box(), () -> panel.draw(canvas)));
            room = room.rightOf(panel.box().right() + BESIDE_FIGURES);
        }
        boolean isHelp = content.page() == HudContent.Page.HELP;
        Box belowLabels = room;
        if (content.comparison() != null && !isHelp) {
            var wipe = new WipeLine(canvas, area, room, content.comparison());
            addWipe(parts, wipe, content.comparison());
            belowLabels = new Box(
                    room.left(),
                    wipe.labels().get(0).bottom(),
                    room.right(),
                    wipe.handle().top());
            room = content.comparison().difference().isEmpty()
                    ? room
                    : room.above(wipe.difference().top());
        }
        if (!content.messages().isEmpty()) {
            var bar = new MessageBar(canvas, area, room, content.messages());
            parts.add(new Part("messages", bar.box(), bar::draw));
            room = room.above(bar.box().top());
        }
        if (isHelp) {
            int rows = HelpPanel.rows(content);
            Box box = HelpPanel.box(area, room, rows);
            parts.add(new Part("help", box, () -> HelpPanel.draw(canvas, box, content.keys(), rows)));
            return parts;
        }
        addSight(parts, content.sight(), area, room);
        if (content.banner() != null) {
            var banner = new BannerPanel(canvas, area, belowLabels, content.banner());
            parts.add(new Part("banner", banner.box(), () -> banner.draw(canvas)));
        }
        return parts;
    }

    private void addWipe(List<Part> parts, WipeLine wipe, HudContent.Comparison comparison) {
        parts.add(new Part("handle", wipe.handle(), wipe::drawHandle));
        parts.add(new Part("left label", wipe.labels().get(0), wipe::drawLabels));
        parts.add(new Part("right label", wipe.labels().get(1), () -> {}));
        if (!comparison.difference().isEmpty()) {
            parts.add(new Part("difference", wipe.difference(), wipe::drawDifference));
        }
    }

    private void addSight(List<Part> parts, HudContent.Sight sight, Area area, Box room) {
        if (sight == null) {
            return;
        }
        parts.add(new Part("crosshair", Crosshair.box(area, sight), () -> Crosshair.draw(canvas, area, sight)));
        if (sight.prompt() != null) {
            var prompt = new PromptLine(canvas, area, room, sight.prompt());
            parts.add(new Part("prompt", prompt.box(), () -> prompt.draw(canvas)));
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
        MessageBar bar = new MessageBar(canvas, area, Box.of(area), messages);
        if (bar.box().top() >= panel.bottom()) {
            panel.draw(canvas);
            bar.draw();
        } else {
            panel.draw(canvas, messages.get(messages.size() - 1), HudPalette.INK);
        }
    }
}
