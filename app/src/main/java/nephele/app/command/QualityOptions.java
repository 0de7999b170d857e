package nephele.app.command;

import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import nephele.engine.render.frame.QualityField;
import nephele.host.draw.QualityChoice;
import picocli.CommandLine.Option;

/** The quality options that all drawing commands share. */
final class QualityOptions {
    @Option(
            names = "--quality",
            paramLabel = "Q",
            defaultValue = "high",
            description =
                    "low, medium, high, ultra or auto, as play draws them: low with half the resolution, scaled up;"
                            + " auto as play begins (default: high).")
    private String quality;

    @Option(
            names = "--set",
            paramLabel = "KEY=VALUE",
            parameterConsumer = SettingConsumer.class,
            description =
                    "Change single settings: ${COMPLETION-CANDIDATES}; debug=ids draws every solid in its own colour.",
            completionCandidates = Names.class)
    private Map<String, String> settings = new LinkedHashMap<>();

    /** The names of all settings, for the help. */
    static final class Names implements Iterable<String> {
        @Override
        public Iterator<String> iterator() {
            return QualityChoice.FIELDS.stream().map(QualityField::name).iterator();
        }
    }

    QualityChoice choice() {
        var choice = new QualityChoice(quality, settings);
        choice.check();
        return choice;
    }
}
