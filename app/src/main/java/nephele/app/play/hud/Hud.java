package nephele.app.play.hud;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import nephele.engine.render.pass.overlay.FontAtlas;
import nephele.engine.render.pass.overlay.OverlayCanvas;

/** Updates the overlay's canvas; fills it again only when content, size or scale have changed. */
public final class Hud {
    private static final double BESIDE_FIGURES = 8;
    private static final double UNDER_BANNER_FRACTION = 0.02;

    private final OverlayCanvas canvas;
    private HudContent shown;
    private Area shownArea;
    private double shownScale;

    public Hud(FontAtlas letters) {
        canvas = new OverlayCanvas(letters);
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
        if (content.sight() != null && content.sight().goal() != null) {
            content.sight().goal().draw(canvas, area);
        }
        parts(content, area).forEach(part -> part.drawing.run());
    }

    /** A part of the overlay, and what draws it inside its box. */
    record Part(String name, Box box, Runnable drawing) {}

    /** Returns the parts of the overlay without those of a menu: none covers another. */
    List<Part> parts(HudContent content, Area area) {
        Layout layout = new Layout(area);
        if (!content.figures().isEmpty() && content.menu() == null) {
            layout.addFigures(content.figures());
        }
        boolean isHelp = content.page() == HudContent.Page.HELP;
        if (content.comparison() != null && !isHelp) {
            layout.addWipe(content.comparison());
        }
        if (!content.messages().isEmpty()) {
            layout.addMessages(content.messages());
        }
        if (isHelp) {
            layout.addHelp(content);
            return layout.parts;
        }
        if (content.sight() != null) {
            layout.addSight(content.sight());
        }
        if (content.banner() != null) {
            layout.addBanner(content.banner(), content.sight());
        }
        return layout.parts;
    }

    /** Gives each part a place in what the parts before it have left. */
    private final class Layout {
        private final List<Part> parts = new ArrayList<>();
        private final Area area;
        private Box room;
        private Box roomOfBanner;
        /** The figures' box; {@code null} without them. */
        private Box figures;

        Layout(Area area) {
            this.area = area;
            room = Box.of(area);
            roomOfBanner = room;
        }

        void addFigures(List<HudContent.Figure> lines) {
            var panel = new FrameStatisticsPanel(area, lines);
            figures = panel.box();
            parts.add(new Part("figures", figures, () -> panel.draw(canvas)));
        }

        void addWipe(HudContent.Comparison comparison) {
            var wipe = new WipeLine(canvas, area, beside(room), comparison);
            List<Box> labels = wipe.labels();
            parts.add(new Part("handle", wipe.handle(), wipe::drawHandle));
            parts.add(new Part("left label", labels.get(0), wipe::drawLabels));
            parts.add(new Part("right label", labels.get(1), () -> {}));
            roomOfBanner = new Box(
                    0, labels.get(0).bottom(), room.right(), wipe.handle().top());
            if (!comparison.difference().isEmpty()) {
                parts.add(new Part("difference", wipe.difference(), wipe::drawDifference));
                room = room.above(wipe.difference().top());
            }
        }

        void addMessages(List<String> messages) {
            var bar = apart(room, free -> new MessageBar(canvas, area, free, messages), MessageBar::box);
            parts.add(new Part("messages", bar.box(), bar::draw));
            room = room.above(bar.box().top());
        }

        void addHelp(HudContent content) {
            int rows = HelpPanel.rows(content);
            Box box = apart(room, free -> HelpPanel.box(area, free, rows), placed -> placed);
            parts.add(new Part("help", box, () -> HelpPanel.draw(canvas, box, content, rows)));
        }

        void addSight(HudContent.Sight sight) {
            parts.add(new Part("crosshair", Crosshair.box(area, sight), () -> Crosshair.draw(canvas, area, sight)));
            if (sight.prompt() != null && sight.goal() == null) {
                var line = apart(room, free -> new PromptLine(canvas, area, free, sight.prompt()), PromptLine::box);
                parts.add(new Part("prompt", line.box(), () -> line.draw(canvas)));
            }
        }

        /** Adds a banner; below the crosshair if there is room and a goal is marked, which is seldom that low. */
        void addBanner(HudContent.Banner banner, HudContent.Sight sight) {
            BannerPanel panel = banner(roomOfBanner, banner, BannerPanel.UPPER_FRACTION);
            if (sight != null && sight.goal() != null) {
                double bottom = Math.min(room.bottom(), roomOfBanner.bottom());
                Box free = roomOfBanner
                        .below(Crosshair.box(area, sight).bottom())
                        .above(bottom - Math.rint(UNDER_BANNER_FRACTION * area.height()));
                BannerPanel low = banner(free, banner, BannerPanel.LOWEST_FRACTION);
                panel = low.isWhole() ? low : panel;
            }
            BannerPanel placed = panel;
            parts.add(new Part("banner", placed.box(), () -> placed.draw(canvas)));
        }

        private BannerPanel banner(Box within, HudContent.Banner banner, double topFraction) {
            return apart(within, free -> new BannerPanel(canvas, area, free, banner, topFraction), BannerPanel::box);
        }

        /** Returns what is placed in a room; beside the figures if it would cover them otherwise. */
        private <T> T apart(Box free, Function<Box, T> placed, Function<T, Box> box) {
            T first = placed.apply(free);
            return figures == null || !box.apply(first).overlaps(figures) ? first : placed.apply(beside(free));
        }

        private Box beside(Box free) {
            return figures == null ? free : free.rightOf(figures.right() + BESIDE_FIGURES);
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
