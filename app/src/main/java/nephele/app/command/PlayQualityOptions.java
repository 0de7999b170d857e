package nephele.app.command;

import java.util.LinkedHashMap;
import java.util.Map;
import nephele.host.draw.QualityChoice;
import picocli.CommandLine.Option;

/** The quality options of a game, which has the player's settings as default. */
final class PlayQualityOptions {
    @Option(
            names = "--quality",
            paramLabel = "Q",
            description = "low, medium, high, ultra or auto (default: that of the settings, at first auto).")
    private String quality;

    @Option(
            names = "--set",
            paramLabel = "KEY=VALUE",
            parameterConsumer = SettingConsumer.class,
            description = "Change single settings, as in render.")
    private Map<String, String> settings = new LinkedHashMap<>();

    /** Returns the choice; null if no option states one. */
    QualityChoice choice() {
        if (quality == null && settings.isEmpty()) {
            return null;
        }
        var choice = new QualityChoice(quality == null ? "auto" : quality, settings);
        choice.check();
        return choice;
    }
}
