package nephele.app.play.hud;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import nephele.app.play.hud.HudContent.Banner;
import nephele.app.play.hud.HudContent.Comparison;
import nephele.app.play.hud.HudContent.Figure;
import nephele.app.play.hud.HudContent.Page;
import nephele.app.play.hud.HudContent.Sight;
import nephele.app.settings.Phrase;
import nephele.app.window.Input;
import nephele.app.window.KeyBindings;
import nephele.engine.level.Language;
import nephele.engine.render.pass.overlay.DrawnBounds;
import nephele.engine.render.pass.overlay.FontAtlas;
import nephele.engine.render.pass.overlay.OverlayCanvas;
import nephele.engine.scene.ShotPalette;
import nephele.host.compare.Wipe;
import nephele.host.playthrough.CrosshairState;
import nephele.host.playthrough.CrosshairState.Half;
import nephele.host.playthrough.CrosshairState.Shot;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Figures, hints, messages, labels and pages never cover each other, in any window and language. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS) // the letters are baked once
@Execution(ExecutionMode.CONCURRENT)
class OverlayLayoutTest {
    /** Letters have a border without ink in the atlas, in points. */
    private static final double LETTER_BORDER = 6;

    private static final double ROUNDING = 1e-6;

    private final Hud hud = new Hud(new FontAtlas());
    private int seen;

    @Execution(ExecutionMode.SAME_THREAD) // the overlay is one
    @ParameterizedTest
    @CsvSource({
        "640, 360, 1",
        "640, 360, 2",
        "320, 180, 1",
        "300, 500, 1",
        "800, 600, 1",
        "960, 540, 1",
        "1280, 720, 1",
        "1280, 720, 2",
        "1280, 1024, 1",
        "1600, 900, 1",
        "1920, 1080, 1",
        "1920, 1200, 1.25",
        "2560, 1080, 1",
        "2560, 1440, 2",
        "3440, 1440, 1",
        "3840, 2160, 1",
        "3840, 2160, 2"
    })
    void noPartCoversAnother(int width, int height, double windowScale) {
        seen = 0;
        Area area = Area.of(width, height, windowScale);
        for (Language language : Language.values()) {
            for (List<Figure> figures : List.of(figures(0), figures(9), figures(28))) {
                for (List<String> messages : messages(language)) {
                    check(area, language, figures, messages);
                }
            }
        }
        assertTrue(seen > 300, seen + " layouts");
    }

    private void check(Area area, Language language, List<Figure> figures, List<String> messages) {
        var keys = new HudContent.Keys(KeyBindings.usual(), Input.Device.KEYBOARD, language);
        for (Comparison comparison : comparisons(language)) {
            String[] prompts = {null, Phrase.PROMPT_SECOND.in(language), uneven(language)};
            for (int i = 0; i < prompts.length; i++) {
                Banner banner = banners(language)[i];
                GoalMark goal = i == 1 ? GoalMark.at(area, true, 10, -40, 20, 12) : null;
                Sight sight =
                        new Sight(new CrosshairState(0, 0, half(), half()), ShotPalette.BLUE_ORANGE, prompts[i], goal);
                check(area, new HudContent(null, Page.NONE, figures, messages, banner, sight, comparison, keys, null));
            }
            check(
                    area,
                    new HudContent(
                            null, Page.HELP, figures, messages, null, null, comparison, keys, banners(language)[1]));
        }
    }

    /** The words of a goal that is marked do not cover it where goals mostly are, from the crosshair upwards. */
    @Execution(ExecutionMode.SAME_THREAD) // the overlay is one
    @ParameterizedTest
    @CsvSource({"640, 360", "960, 540", "1280, 720", "2560, 1080"})
    void theBannerIsBelowAMarkedGoal(int width, int height) {
        Area area = new Area(width, height);
        for (Language language : Language.values()) {
            for (List<Figure> figures : List.of(figures(0), figures(9))) {
                var keys = new HudContent.Keys(KeyBindings.usual(), Input.Device.KEYBOARD, language);
                var sight = new Sight(
                        new CrosshairState(0, 0, half(), half()),
                        ShotPalette.BLUE_ORANGE,
                        Phrase.PROMPT_SECOND.in(language),
                        GoalMark.at(area, true, 10, -40, 20, 12));
                var messages = List.of(Phrase.TOO_HEAVY.in(language));
                Banner banner = banners(language)[1];
                var content = new HudContent(null, Page.NONE, figures, messages, banner, sight, null, keys, null);
                Hud.Part last = hud.parts(content, area).stream()
                        .reduce((one, other) -> other)
                        .orElseThrow();
                assertTrue(
                        last.name().equals("banner") && last.box().top() > area.centreY(), told(last, area, content));
            }
        }
    }

    private void check(Area area, HudContent content) {
        seen++;
        List<Hud.Part> parts = hud.parts(content, area);
        for (int i = 0; i < parts.size(); i++) {
            Box box = parts.get(i).box();
            Supplier<String> what = told(parts.get(i), area, content);
            assertTrue(box.left() >= 0 && box.right() <= area.width() + 1, what);
            assertTrue(box.top() >= 0 && box.bottom() <= area.height() + ROUNDING, what);
            assertTrue(box.width() > 0 && box.height() > 0, what);
            for (Hud.Part other : parts.subList(0, i)) {
                assertTrue(areApart(box, other.box()), told(other, area, content));
            }
        }
        if (seen % 29 == 0) {
            hud.canvas(content, area, 1);
            parts.forEach(part -> assertIsInside(part, content, area));
        }
    }

    private static Supplier<String> told(Hud.Part part, Area area, HudContent content) {
        return () -> part.name() + " " + part.box() + " in " + area + " " + content;
    }

    /** A part draws nothing outside its box. */
    private void assertIsInside(Hud.Part part, HudContent content, Area area) {
        OverlayCanvas drawn = hud.canvas(content, area, 1);
        drawn.begin(1);
        part.drawing().run();
        boolean isLarger = part.name().equals("crosshair") || part.name().endsWith("label");
        if (drawn.isEmpty() || isLarger) { // the ring's glyphs have wide borders; both labels are drawn together
            return;
        }
        DrawnBounds bounds = DrawnBounds.of(drawn);
        Box box = part.box();
        String what = part.name() + " " + box + " draws " + bounds;
        assertTrue(bounds.left() >= box.left() - LETTER_BORDER && bounds.right() <= box.right() + LETTER_BORDER, what);
        assertTrue(bounds.top() >= box.top() - LETTER_BORDER && bounds.bottom() <= box.bottom() + LETTER_BORDER, what);
    }

    private static boolean areApart(Box one, Box other) {
        return one.right() <= other.left() + ROUNDING
                || other.right() <= one.left() + ROUNDING
                || one.bottom() <= other.top() + ROUNDING
                || other.bottom() <= one.top() + ROUNDING;
    }

    private static Half half() {
        return new Half(false, Shot.REFUSED, 0);
    }

    private static List<Figure> figures(int count) {
        List<Figure> figures = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            figures.add(new Figure("  a step of the frame " + "with a long name ".repeat(i % 3), i * 1000 + ".25 ms"));
        }
        return figures;
    }

    private static List<List<String>> messages(Language language) {
        String slow = Phrase.SLOW.in(language) + " " + Phrase.ADVICE_OTHER_WINDOW.in(language);
        String path = "/home/somebody/" + "a-folder-with-a-name/".repeat(9) + "level-2026-11-28.png";
        String hint = Phrase.HINT_GIVEN.in(language, 3, 3, "a word and ".repeat(12) + "the end.");
        return List.of(
                List.of(),
                List.of(Phrase.TOO_HEAVY.in(language)),
                List.of(Phrase.HINT_OFFERED.in(language, "H"), hint),
                List.of(Phrase.TOO_HEAVY.in(language), slow, Phrase.SAVED.in(language, path)),
                List.of(Phrase.NOT_LOADED.in(language, path + ": " + "and why it is so ".repeat(15))));
    }

    private static String uneven(Language language) {
        return Phrase.NO_PORTAL.in(language, Phrase.REFUSED_NOT_FLAT.in(language, 99999));
    }

    private static Banner[] banners(Language language) {
        return new Banner[] {
            null,
            new Banner("Above the clouds", "Desça através das nuvens: siga as luzes e confie na queda; depois, suba."),
            new Banner(Phrase.LOADING.in(language), Phrase.BAKING.in(language, 5))
        };
    }

    private static Comparison[] comparisons(Language language) {
        String differs = Phrase.DIFFERS.in(language, "procedural", "billboard", "0.123", "+12.3");
        return new Comparison[] {
            null,
            new Comparison(new Wipe(0), "procedural   12.5 ms", "billboard   8.1 ms", ""),
            new Comparison(Wipe.MIDDLE, "procedural   12.5 ms", "billboard   8.1 ms", differs),
            new Comparison(new Wipe(1), "skybox", "particles   123 ms", differs)
        };
    }
}
