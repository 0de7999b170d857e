package nephele.workshop.prove.picture;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.ProofResult;

/**
 * The sums over the lit pictures of one level by one technique.
 *
 * @param flips sum of the mean FLIP of the judged pictures; {@code averagedFlips} of the same pictures drawn larger and
 *     averaged
 * @param drawn sum of all values, {@code traced} likewise
 * @param worst the greatest mean FLIP of a picture, {@code whereWorst} the picture
 */
record LitSums(
        double pictures,
        double flips,
        double averagedFlips,
        double drawn,
        double traced,
        double worst,
        String whereWorst) {
    /**
     * Drawn pixels along each side of a compared pixel in the averaged pictures, which show how much of the error is
     * aliasing.
     */
    static final int FINER = 2;

    private static final String PICTURES = ": pictures";
    private static final String FLIPS = ": sum of their mean FLIP";
    private static final String AVERAGED = ": sum of their mean FLIP, averaged";
    private static final String DRAWN = ": radiance drawn";
    private static final String TRACED = ": radiance traced";
    private static final String WORST = ": greatest mean FLIP";

    /** Returns the sums from the joined {@link #figures} of all batches; empty if the series has no picture. */
    static Optional<LitSums> of(ProofResult result, String series) {
        return result.figure(series + WORST)
                .map(worst -> new LitSums(
                        result.value(series + PICTURES),
                        result.value(series + FLIPS),
                        result.value(series + AVERAGED),
                        result.value(series + DRAWN),
                        result.value(series + TRACED),
                        worst.value(),
                        worst.unit()));
    }

    List<Figure> figures(String series) {
        return List.of(
                Figure.sum(series + PICTURES, pictures, ""),
                Figure.sum(series + FLIPS, flips, ""),
                Figure.sum(series + AVERAGED, averagedFlips, ""),
                Figure.sum(series + DRAWN, drawn, ""),
                Figure.sum(series + TRACED, traced, ""),
                Figure.greatest(series + WORST, worst, whereWorst));
    }

    double flip() {
        return flips / pictures;
    }

    double averagedFlip() {
        return averagedFlips / pictures;
    }

    /** Returns the relative difference of the radiance; the drawn radiance itself if the traced one is 0. */
    double bias() {
        return traced == 0 ? drawn : drawn / traced - 1;
    }

    /** Returns the figures for a reader, to be joined with those of other series. */
    List<Figure> summary(String series) {
        return List.of(
                Figure.sum("pictures", pictures, ""),
                Figure.sum("sum of their mean FLIP", flips, ""),
                Figure.sum("the same, drawn " + FINER + " times as large and averaged", averagedFlips, ""),
                Figure.greatest("greatest mean FLIP of a level", flip(), "(" + series + ")"),
                Figure.greatest(
                        "greatest of a level " + FINER + " times as large, averaged",
                        averagedFlip(),
                        "(" + series + ")"),
                Figure.greatest("greatest bias of a level", 100 * Math.abs(bias()), "% (" + series + ")"),
                Figure.greatest("greatest mean FLIP of a picture", worst, whereWorst));
    }

    String inWords(String series) {
        return String.format(
                Locale.ROOT,
                "%s: mean FLIP %.4f (%.4f drawn %d times as large and averaged), bias %+.2f %%, %.0f pictures; worst"
                        + " %.4f %s",
                series,
                flip(),
                averagedFlip(),
                FINER,
                100 * bias(),
                pictures,
                worst,
                whereWorst);
    }
}
