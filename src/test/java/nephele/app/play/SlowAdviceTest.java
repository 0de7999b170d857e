package nephele.app.play;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import nephele.app.play.SlowAdvice.Cause;
import nephele.app.play.SlowAdvice.PictureNow;
import nephele.app.play.SlowAdvice.QualityNow;
import nephele.app.settings.GameSettings;
import nephele.app.settings.Phrase;
import nephele.app.settings.PlayerFiles;
import nephele.app.settings.Settings;
import nephele.app.settings.Settings.QualityPreset;
import nephele.app.window.Size;
import nephele.app.window.WindowMode;
import nephele.engine.level.Language;
import nephele.host.draw.QualityChoice;
import nephele.host.userfile.UserFolders;
import org.junit.jupiter.api.Test;

/** Advice about slow frames names what helps, and never what is so already. */
class SlowAdviceTest {
    private static final long SECOND = 1_000_000_000L;

    private final PlayerFiles files = new PlayerFiles(new UserFolders(null, null, null));
    private final AutoQuality auto = new AutoQuality(files, "llvmpipe", true, null);

    private QualityNow quality(QualityChoice option) {
        var player = new PlayRequest.Player(files, null);
        return auto.now(new PlayRequest(null, null, option, null, null, null, null, null, player));
    }

    private static String advice(QualityNow quality, PictureNow picture) {
        return SlowAdvice.text(new SlowAdvice.Cause(quality, picture), Language.EN);
    }

    @Test
    void theLowestQualityIsNotLowered() {
        for (QualityPreset preset : QualityPreset.values()) {
            files.keep(files.settings().with(Settings.QUALITY, preset));
            QualityNow expected =
                    switch (preset) {
                        case LOW -> QualityNow.LOWEST;
                        case AUTO -> QualityNow.ADAPTS;
                        default -> QualityNow.CAN_BE_LOWERED;
                    };
            assertEquals(expected, quality(null), preset.toString());
        }
        assertEquals(QualityNow.LOWEST, quality(new QualityChoice("low", Map.of())));
        assertEquals(QualityNow.FIXED_AT_START, quality(new QualityChoice("high", Map.of())));
        for (PictureNow picture : PictureNow.values()) {
            String lowest = advice(QualityNow.LOWEST, picture);
            assertTrue(!lowest.contains("quality"), lowest);
        }
    }

    /** Automatic quality adapts until its cheapest point is reached. */
    @Test
    void automaticQualityAtItsCheapestPointIsTheLowest() {
        var request =
                new PlayRequest(null, null, null, null, null, null, null, null, new PlayRequest.Player(files, null));
        for (int frame = 0; frame < 2000 && auto.now(request) != QualityNow.LOWEST; frame++) {
            auto.frame(request, 900, 1);
        }
        assertEquals(QualityNow.LOWEST, auto.now(request));
    }

    @Test
    void theSmallestPictureIsNotMadeSmaller() {
        GameSettings usual = GameSettings.DEFAULT;
        GameSettings least = usual.with(Settings.RESOLUTION, Settings.LEAST_RESOLUTION);
        Size large = new Size(1920, 1080);
        for (WindowMode mode : WindowMode.values()) {
            assertEquals(PictureNow.SMALLEST, SlowAdvice.picture(mode, new Size(640, 360), usual));
        }
        assertEquals(PictureNow.CAN_BE_SMALLER, SlowAdvice.picture(WindowMode.WINDOWED, large, usual));
        assertEquals(PictureNow.CAN_BE_SMALLER, SlowAdvice.picture(WindowMode.FULLSCREEN, large, usual));
        assertEquals(PictureNow.SMALLEST, SlowAdvice.picture(WindowMode.FULLSCREEN, large, least));
        assertEquals(PictureNow.COVERS_SCREEN, SlowAdvice.picture(WindowMode.BORDERLESS, large, least));
        assertTrue(advice(QualityNow.LOWEST, PictureNow.CAN_BE_SMALLER).contains("smaller resolution"));
        assertEquals(Phrase.SLOW.in(Language.EN), advice(QualityNow.LOWEST, PictureNow.SMALLEST));
        assertNotEquals(Phrase.SLOW.in(Language.EN), advice(QualityNow.LOWEST, PictureNow.COVERS_SCREEN));
    }

    /** Ten minutes of slow frames while the quality sinks to its end: a line for each cause, none while a hint is shown. */
    @Test
    void eachCauseIsToldOnceAndNotOverAHint() {
        SlowAdvice advice = new SlowAdvice();
        Cause adapts = new Cause(QualityNow.ADAPTS, PictureNow.CAN_BE_SMALLER);
        Cause lowest = new Cause(QualityNow.LOWEST, PictureNow.CAN_BE_SMALLER);
        List<String> told = new ArrayList<>();
        for (long second = 0; second < 600; second += 2) {
            Cause cause = second < 20 || second % 60 == 0 ? adapts : lowest;
            boolean isHintShown = second < 6 || second >= 20 && second < 30;
            if (advice.isNews(cause, second * SECOND, isHintShown)) {
                told.add(second + " " + cause.quality());
            }
        }
        assertEquals(List.of("6 ADAPTS", "30 LOWEST"), told);
    }

    @Test
    void aCauseThatWasAwayForLongIsToldAgain() {
        SlowAdvice advice = new SlowAdvice();
        Cause cause = new Cause(QualityNow.LOWEST, PictureNow.SMALLEST);
        assertTrue(advice.isNews(cause, 0, false));
        assertFalse(advice.isNews(cause, 100 * SECOND, false));
        assertFalse(advice.isNews(cause, 250 * SECOND, false), "it was away for 150 s");
        assertFalse(advice.isNews(cause, 431 * SECOND, true), "a hint is read");
        assertTrue(advice.isNews(cause, 433 * SECOND, false));
    }
}
