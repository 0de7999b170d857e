package nephele.app.play;

import java.util.Locale;
import nephele.app.play.hud.HudContent;
import nephele.app.settings.Phrase;
import nephele.engine.level.Language;
import nephele.host.compare.CloudComparison;
import nephele.host.compare.ComparisonFigures;
import nephele.host.compare.PictureDifference;
import nephele.host.compare.TechniquePair;
import nephele.host.compare.Wipe;

/** The figures of a comparison in words; made again only when they change. */
public final class ComparisonTexts {
    private ComparisonFigures figures;
    private Language language;
    private HudContent.Comparison shown;

    /** Returns what the overlay shows. */
    public HudContent.Comparison of(CloudComparison comparison, Wipe wipe, Language wanted) {
        if (figures != comparison.figures()
                || language != wanted
                || !shown.wipe().equals(wipe)) {
            figures = comparison.figures();
            language = wanted;
            shown = texts(comparison.techniques(), wipe);
        }
        return shown;
    }

    private HudContent.Comparison texts(TechniquePair techniques, Wipe wipe) {
        return new HudContent.Comparison(
                wipe,
                label(Phrase.ofTechnique(techniques.left()).in(language), figures.leftMillis()),
                label(Phrase.ofTechnique(techniques.right()).in(language), figures.rightMillis()),
                difference(techniques, figures.difference(), language));
    }

    private static String label(String technique, double millis) {
        return millis == 0 ? technique : String.format(Locale.ROOT, "%s   %s ms", technique, rounded(millis));
    }

    private static String rounded(double millis) {
        return String.format(Locale.ROOT, millis < 10 ? "%.1f" : "%.0f", millis);
    }

    /** Returns a sentence; empty before the first measurement. */
    static String difference(TechniquePair techniques, PictureDifference difference, Language language) {
        if (difference == null) {
            return "";
        }
        return difference.isNone()
                ? Phrase.NO_DIFFERENCE.in(language)
                : Phrase.DIFFERS.in(
                        language,
                        Phrase.ofTechnique(techniques.tried()).in(language),
                        Phrase.ofTechnique(techniques.reference()).in(language),
                        String.format(Locale.ROOT, "%.3f", difference.flip()),
                        difference.lightPercent());
    }
}
