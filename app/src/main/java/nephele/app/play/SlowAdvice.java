package nephele.app.play;

import nephele.app.settings.GameSettings;
import nephele.app.settings.Settings;
import nephele.app.text.Phrase;
import nephele.app.window.GameWindow;
import nephele.app.window.WindowMode;
import nephele.app.window.WindowSize;
import nephele.engine.level.Language;

/** The line for a player whose frames take too long: it names the setting that helps, never one that is at its end. */
final class SlowAdvice {
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

    private SlowAdvice() {}

    static PictureNow picture(GameWindow window, GameSettings settings) {
        return picture(window.mode(), new WindowSize(window.width(), window.height()), settings);
    }

    /** @param shown the picture's size in pixels */
    static PictureNow picture(WindowMode mode, WindowSize shown, GameSettings settings) {
        WindowSize least = Settings.size(Settings.LEAST_RESOLUTION);
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

    static String text(QualityNow quality, PictureNow picture, Language language) {
        Phrase advice =
                switch (quality) {
                    case CAN_BE_LOWERED -> Phrase.ADVICE_QUALITY;
                    case FIXED_AT_START -> Phrase.ADVICE_QUALITY_AT_START;
                    case ADAPTS -> Phrase.QUALITY_ADAPTS;
                    case LOWEST ->
                        switch (picture) {
                            case CAN_BE_SMALLER -> Phrase.ADVICE_RESOLUTION;
                            case COVERS_SCREEN -> Phrase.ADVICE_OTHER_WINDOW;
                            case SMALLEST -> null;
                        };
                };
        String slow = Phrase.SLOW.in(language);
        return advice == null ? slow : slow + " " + advice.in(language);
    }
}
