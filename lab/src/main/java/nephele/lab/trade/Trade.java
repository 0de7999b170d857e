package nephele.lab.trade;

import java.util.List;
import java.util.function.Function;

/**
 * A subject of the report: a parameter that trades speed for accuracy.
 *
 * @param subject its name as typed in a command
 * @param text its description in the report
 * @param qualityFields the components of {@link nephele.engine.render.frame.Quality} that it covers; often none
 * @param settings in the order of growing cost where there is one
 * @param usual index of the setting in the preset {@code high}; costs are relative to it
 * @param figures names, with units, of the results that are reported besides the error
 * @param level the level in which it is always measured; {@code null} for the level of the request
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

    /** Returns the same subject, always measured in a level of the jar. */
    public Trade in(String otherLevel) {
        return in(otherLevel, subject, text);
    }

    /** Returns the same parameter measured in another level of the jar, in which it matters more. */
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
     * The description of a subject in the report.
     *
     * @param title a few words
     * @param about the effect of the parameter, in a sentence or two
     * @param exact the reference that the settings are compared with
     */
    public record Text(String title, String about, String exact) {}
}
