package nephele.workshop.prove.picture;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.measure.HdrFlip;
import nephele.engine.measure.LinearPicture;
import nephele.workshop.prove.proof.ProofResult;

/** Compares drawn lit pictures with traced ones: their mean FLIP, and the relative bias of their radiance. */
final class LitTally {
    static final double MOST_FLIP = 0.05;
    static final double MOST_BIAS = 0.01;

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
        var picture = new LitSums(
                1, flip, HdrFlip.of(reference, averaged).mean(), sum(once), sum(reference), flip, "in " + camera);
        sums = sums.and(new ProofResult(0, 0, picture.figures(series), List.of()));
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
            var found = LitSums.of(soFar, name);
            if (found.isPresent()) {
                summary = summary.and(new ProofResult(0, 0, found.get().summary(name), List.of()));
                if (found.get().flip() > MOST_FLIP || Math.abs(found.get().bias()) > MOST_BIAS) {
                    failures.add(found.get().inWords(name));
                }
            }
        }
        return ProofResult.of(soFar.units(), failures, summary.figures());
    }
}
