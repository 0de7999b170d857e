package nephele.lab.trade;

import java.util.List;
import java.util.function.Function;

/**
 * A knob that buys speed with error, or the reverse.
 *
 * @param subject as it is typed
 * @param text for who reads the report
 * @param qualityFields the components of {@link nephele.engine.render.frame.Quality} that it explains; often none
 * @param settings in the order of growing effort where there is one
 * @param usual index of what a player of preset {@code high} gets: costs are ratios to it
 * @param figures names, with units, of what is reported besides the error
 * @param level where it is always measured; {@code null} for the one that is asked for
 */
public record Trade(
        String subject,
        Text text,
        List<String> qualityFields,
        List<Setting> settings,
        int usual,
        ErrorMetric error,
        List<String> figures,
        CostMetric cost,
        String level,
        Function<TradeSite, Experiment> experiment) {
    public Trade {
        long names = settings.stream().map(Setting::name).distinct().count();
        if (names != settings.size() || usual < 0 || usual >= settings.size()) {
            throw new IllegalArgumentException(
                    subject + ": settings have names of their own, and one is the usual one");
        }
    }

    /** The same knob in a level of the jar where it matters more than in the one that is reported. */
    public Trade in(String otherLevel, String otherSubject, Text otherText) {
        return new Trade(
                otherSubject,
                otherText,
                qualityFields,
                settings,
                usual,
                error,
                figures,
                cost,
                otherLevel,
                site -> experiment.apply(site.in(otherLevel)));
    }

    /**
     * What a reader is told.
     *
     * @param title a few words
     * @param about what the knob does, in a sentence or two
     * @param exact what the settings are compared with
     */
    public record Text(String title, String about, String exact) {}
}
