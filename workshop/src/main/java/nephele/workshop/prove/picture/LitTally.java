package nephele.workshop.prove.picture;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import nephele.engine.measure.HdrFlip;
import nephele.engine.measure.LinearPicture;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.ProofResult;

/** Compares drawn lit pictures with traced ones: their mean FLIP, and the relative bias of their radiance. */
final class LitTally {
    /**
     * Drawn pixels along each side of a compared pixel in the averaged pictures, which show how much of the error is
     * aliasing.
     */
    static final int FINER = 2;

    static final double MOST_FLIP = 0.05;
    static final double MOST_BIAS = 0.01;

    private static final String PICTURES = ": pictures";
    private static final String FLIPS = ": sum of their mean FLIP";
    private static final String AVERAGED = ": sum of their mean FLIP, averaged";
    private static final String DRAWN = ": radiance drawn";
    private static final String TRACED = ": radiance traced";
    private static final String WORST = ": greatest mean FLIP";

    private ProofResult sums = ProofResult.NOTHING;

    /**
     * Adds a picture to a series.
     *
     * @param camera a description of the camera and the way to draw it again
     * @param once the judged picture
     * @param averaged the same picture, drawn larger and averaged; reported, not judged
     */
    void compare(String series, String camera, LinearPicture reference, LinearPicture once, LinearPicture averaged) {
        double flip = HdrFlip.of(reference, once).mean();
        List<Figure> figures = List.of(
                Figure.sum(series + PICTURES, 1, ""),
                Figure.sum(series + FLIPS, flip, ""),
                Figure.sum(series + AVERAGED, HdrFlip.of(reference, averaged).mean(), ""),
                Figure.sum(series + DRAWN, sum(once), ""),
                Figure.sum(series + TRACED, sum(reference), ""),
                Figure.greatest(series + WORST, flip, "in " + camera));
        sums = sums.and(new ProofResult(0, 0, figures, List.of()));
    }

    private static double sum(LinearPicture picture) {
        double sum = 0;
        for (float value : picture.rgb()) {
            sum += value;
        }
        return sum;
    }

    /** Returns the sums of every series, not yet judged. */
    ProofResult result(long units) {
        return new ProofResult(units, 0, sums.figures(), List.of());
    }

    /** Returns the result with the sums of each series replaced by a summary, and judges each series. */
    static ProofResult judged(ProofResult soFar, List<String> series) {
        var failures = new ArrayList<String>();
        var summary = ProofResult.NOTHING;
        for (String name : series) {
            Optional<Figure> worst = soFar.figure(name + WORST);
            if (worst.isPresent()) {
                summary = summary.and(summary(soFar, name, worst.get(), failures));
            }
        }
        return ProofResult.of(soFar.units(), failures, summary.figures());
    }

    /** Returns the figures of a series for a reader, to be joined with those of others, and judges it. */
    private static ProofResult summary(ProofResult sums, String series, Figure worst, List<String> failures) {
        double pictures = sums.value(series + PICTURES);
        double flip = sums.value(series + FLIPS) / pictures;
        double averagedFlip = sums.value(series + AVERAGED) / pictures;
        double drawn = sums.value(series + DRAWN);
        double traced = sums.value(series + TRACED);
        // The drawn radiance itself if the traced one is 0.
        double bias = traced == 0 ? drawn : drawn / traced - 1;
        if (flip > MOST_FLIP || Math.abs(bias) > MOST_BIAS) {
            failures.add(String.format(
                    Locale.ROOT,
                    "%s: mean FLIP %.4f (%.4f drawn %d times as large and averaged), bias %+.2f %%, %.0f pictures;"
                            + " worst %.4f %s",
                    series,
                    flip,
                    averagedFlip,
                    FINER,
                    100 * bias,
                    pictures,
                    worst.value(),
                    worst.unit()));
        }
        List<Figure> figures = List.of(
                Figure.sum("pictures", pictures, ""),
                Figure.sum("sum of their mean FLIP", sums.value(series + FLIPS), ""),
                Figure.sum(
                        "the same, drawn " + FINER + " times as large and averaged", sums.value(series + AVERAGED), ""),
                Figure.greatest("greatest mean FLIP of a level", flip, "(" + series + ")"),
                Figure.greatest(
                        "greatest of a level " + FINER + " times as large, averaged", averagedFlip, "(" + series + ")"),
                Figure.greatest("greatest bias of a level", 100 * Math.abs(bias), "% (" + series + ")"),
                Figure.greatest("greatest mean FLIP of a picture", worst.value(), worst.unit()));
        return new ProofResult(0, 0, figures, List.of());
    }
}
