package nephele.app.play;

import java.util.HashMap;
import java.util.Map;
import nephele.app.settings.GameSettings;
import nephele.app.settings.Phrase;
import nephele.app.settings.Settings;
import nephele.app.window.GameWindow;
import nephele.app.window.Size;
import nephele.app.window.WindowMode;
import nephele.engine.level.Language;

/**
 * The line for a player whose frames take too long: it names the setting that helps, never one that is at its end. Each
 * cause is told once, and again only after it was away for some minutes; never while a hint is read.
 */
final class SlowAdvice {
    /** The time after which a cause that was away is news. */
    static final long AWAY_NANOS = 180_000_000_000L;

    private static final long WINDOW_NANOS = 2_000_000_000L;
    private static final double LEAST_LOSS = 0.1;

    /** The first frames of a level, which may still compile shaders. */
    private static final int SKIPPED_FRAMES = 5;

    private long windowBegin;
    private long lostAtBegin;
    private int skipped;
    /** The last time at which each cause that was reported was present. */
    private final Map<Cause, Long> lastNanos = new HashMap<>();

    /** What the player can do about the quality. */
    enum QualityNow {
        CAN_BE_LOWERED,
        /** An option of the start states it, which goes before the settings. */
        FIXED_AT_START,
        /** It is automatic, and there are cheaper points. */
        ADAPTS,
        LOWEST
    }

    /** What the player can do about the number of pixels. */
    enum PictureNow {
        CAN_BE_SMALLER,
        /** A window without a frame covers the screen, whatever the resolution is. */
        COVERS_SCREEN,
        SMALLEST
    }

    /** A cause of slow frames, named by what the player can do about it. */
    record Cause(QualityNow quality, PictureNow picture) {}

    /** Begins with a level: forgets the time in which it was loaded, but not the causes that were reported. */
    void restart() {
        skipped = 0;
    }

    /** Says a line aside if time was lost for a cause that is news. */
    void say(long nowNanos, CurrentLevel level, GameWindow window, GameSettings settings, Message message) {
        if (isTimeLost(nowNanos, level.session().walk().lostNanos())) {
            var cause = new Cause(level.quality(), picture(window, settings));
            if (isNews(cause, nowNanos, message.showsHint())) {
                message.sayAside(text(cause, settings.get(Settings.LANGUAGE)));
            }
        }
    }

    /**
     * Returns true once for each two seconds of which a tenth was lost: simulated time lags behind real time because
     * frames take longer than 0.25 s.
     *
     * @param lostNanos of simulated time in the level
     */
    boolean isTimeLost(long nowNanos, long lostNanos) {
        if (skipped < SKIPPED_FRAMES) {
            skipped++;
            beginWindow(nowNanos, lostNanos);
        }
        long elapsed = nowNanos - windowBegin;
        if (elapsed < WINDOW_NANOS) {
            return false;
        }
        boolean isLost = lostNanos - lostAtBegin > LEAST_LOSS * elapsed;
        beginWindow(nowNanos, lostNanos);
        return isLost;
    }

    private void beginWindow(long nowNanos, long lostNanos) {
        windowBegin = nowNanos;
        lostAtBegin = lostNanos;
    }

    /** Returns true if a cause of lost time shall be reported now; while a hint is shown it waits for the next notice. */
    boolean isNews(Cause cause, long nowNanos, boolean isHintShown) {
        Long last = lastNanos.get(cause);
        boolean isNews = last == null || nowNanos - last > AWAY_NANOS;
        if (isNews && isHintShown) {
            return false;
        }
        lastNanos.put(cause, nowNanos);
        return isNews;
    }

    static PictureNow picture(GameWindow window, GameSettings settings) {
        return picture(window.mode(), new Size(window.width(), window.height()), settings);
    }

    /** @param shown the picture's size in pixels */
    static PictureNow picture(WindowMode mode, Size shown, GameSettings settings) {
        Size least = Size.parse(Settings.LEAST_RESOLUTION);
        boolean isSmall = (long) shown.width() * shown.height() <= (long) least.width() * least.height();
        if (isSmall) {
            return PictureNow.SMALLEST;
        }
        if (mode == WindowMode.BORDERLESS) {
            return PictureNow.COVERS_SCREEN;
        }
        boolean isLeast = settings.get(Settings.RESOLUTION).equals(Settings.LEAST_RESOLUTION);
        return isLeast ? PictureNow.SMALLEST : PictureNow.CAN_BE_SMALLER;
    }

    static String text(Cause cause, Language language) {
        Phrase advice =
                switch (cause.quality) {
                    case CAN_BE_LOWERED -> Phrase.ADVICE_QUALITY;
                    case FIXED_AT_START -> Phrase.ADVICE_QUALITY_AT_START;
                    case ADAPTS -> Phrase.QUALITY_ADAPTS;
                    case LOWEST ->
                        switch (cause.picture) {
                            case CAN_BE_SMALLER -> Phrase.ADVICE_RESOLUTION;
                            case COVERS_SCREEN -> Phrase.ADVICE_OTHER_WINDOW;
                            case SMALLEST -> null;
                        };
                };
        String slow = Phrase.SLOW.in(language);
        return advice == null ? slow : slow + " " + advice.in(language);
    }
}
