package nephele.app.play;

import java.util.List;
import java.util.Map;
import nephele.app.settings.GameSetting;
import nephele.app.settings.GameSettings;
import nephele.app.settings.Settings;
import nephele.app.settings.Settings.Switch;
import nephele.engine.level.appearance.FlashStyle;
import nephele.engine.sim.state.Assist;
import nephele.engine.sim.state.SimSettings;
import nephele.host.draw.QualityChoice;
import nephele.host.playthrough.PictureMotion;

/** The effects of the player's settings on the game's parts. */
final class ChosenSettings {
    /** The width of pictures for which the horizontal field of view is stated, relative to their height. */
    private static final double ASPECT = 16.0 / 9;

    private ChosenSettings() {}

    /** Returns the vertical field of view, the same for every window. */
    static double verticalFovDegrees(GameSettings settings) {
        double half = Math.toRadians(settings.get(Settings.FIELD_OF_VIEW)) / 2;
        return 2 * Math.toDegrees(Math.atan(Math.tan(half) / ASPECT));
    }

    static QualityChoice quality(GameSettings settings) {
        Map<String, String> more =
                settings.get(Settings.EDGE_FILTER) == Switch.ON ? Map.of("edgeFilter", "morphological") : Map.of();
        return new QualityChoice(GameSetting.word(settings.get(Settings.QUALITY)), more);
    }

    static SimSettings simulation(GameSettings settings) {
        return new SimSettings(SimSettings.DEFAULT.ticksPerSecond(), assists(settings), uprightRate(settings));
    }

    private static List<Assist> assists(GameSettings settings) {
        return switch (settings.get(Settings.ASSISTS)) {
            case NONE -> List.of();
            case USUAL -> Assist.USUAL;
            case ALL -> List.of(Assist.values());
        };
    }

    private static int uprightRate(GameSettings settings) {
        if (settings.get(Settings.REDUCED_MOTION) == Switch.ON) {
            return SimSettings.INSTANT_UPRIGHT_DEGREES_PER_SECOND;
        }
        return switch (settings.get(Settings.UPRIGHT)) {
            case SLOW -> SimSettings.DEFAULT_UPRIGHT_DEGREES_PER_SECOND / 2;
            case NORMAL -> SimSettings.DEFAULT_UPRIGHT_DEGREES_PER_SECOND;
            case FAST -> 2 * SimSettings.DEFAULT_UPRIGHT_DEGREES_PER_SECOND;
            case INSTANT -> SimSettings.INSTANT_UPRIGHT_DEGREES_PER_SECOND;
        };
    }

    /** Returns how much the picture moves by itself. */
    static PictureMotion motion(GameSettings settings) {
        return settings.get(Settings.REDUCED_MOTION) == Switch.ON ? PictureMotion.REDUCED : PictureMotion.FULL;
    }

    /** Returns how flashes of lightning come and go. */
    static FlashStyle flashStyle(GameSettings settings) {
        return settings.get(Settings.REDUCED_FLASHES) == Switch.ON ? FlashStyle.SOFTENED : FlashStyle.NATURAL;
    }
}
