package nephele.app.prove;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import nephele.engine.measure.HdrFlip;
import nephele.engine.measure.LinearPicture;

/** Lit pictures, drawn against traced: how different they look, and how much light is missing or too much. */
final class LitTally {
    static final double MOST_FLIP = 0.05;
    static final double MOST_BIAS = 0.01;

    private final List<String> failures = new ArrayList<>();
    private long pictures;
    private double worstLevelFlip;
    private double worstLevelBias;
    private double worstPictureFlip;
    private double flipOfAll;
    private double onceOfAll;
    private double worstLevelOnce;

    /** The pictures of one level by one technique. */
    final class OfLevel {
        private final String what;
        private int count;
        private double flip;
        private double worstFlip;
        private String worst = "";
        private double drawn;
        private double traced;
        private double once;

        private OfLevel(String what) {
            this.what = what;
        }

        void compare(LinearPicture reference, LinearPicture test, String camera) {
            double error = HdrFlip.of(reference, test).mean();
            if (error >= worstFlip) {
                worstFlip = error;
                worst = camera;
            }
            count++;
            flip += error;
            drawn += sum(test);
            traced += sum(reference);
        }

        /** What the same picture as a player gets it, drawn once a pixel, is off: reported, not judged. */
        void once(LinearPicture reference, LinearPicture test) {
            once += HdrFlip.of(reference, test).mean();
        }

        /** Where nothing shines both are dark. */
        private double bias() {
            return traced == 0 ? drawn : drawn / traced - 1;
        }

        void end() {
            pictures += count;
            flipOfAll += flip;
            onceOfAll += once;
            worstLevelOnce = Math.max(worstLevelOnce, once / count);
            worstPictureFlip = Math.max(worstPictureFlip, worstFlip);
            worstLevelFlip = Math.max(worstLevelFlip, flip / count);
            worstLevelBias = Math.max(worstLevelBias, Math.abs(bias()));
            if (flip / count > MOST_FLIP || Math.abs(bias()) > MOST_BIAS) {
                failures.add(String.format(
                        Locale.ROOT,
                        "%s: mean FLIP %.4f, bias %+.2f %%; worst %.4f in %s",
                        what,
                        flip / count,
                        100 * bias(),
                        worstFlip,
                        worst));
            }
        }
    }

    OfLevel level(String what) {
        return new OfLevel(what);
    }

    private static double sum(LinearPicture picture) {
        double sum = 0;
        for (float value : picture.rgb()) {
            sum += value;
        }
        return sum;
    }

    ProofResult result(long units) {
        return new ProofResult(
                units,
                failures.size(),
                List.of(
                        Figure.sum("pictures", pictures, ""),
                        Figure.sum("sum of their mean FLIP", flipOfAll, ""),
                        Figure.sum("sum of their mean FLIP drawn once a pixel", onceOfAll, ""),
                        Figure.greatest("greatest mean FLIP of a level drawn once a pixel", worstLevelOnce, ""),
                        Figure.greatest("greatest mean FLIP of a picture", worstPictureFlip, ""),
                        Figure.greatest("greatest mean FLIP of a level", worstLevelFlip, ""),
                        Figure.greatest("greatest bias of a level", 100 * worstLevelBias, "%")),
                failures);
    }
}
