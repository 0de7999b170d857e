package nephele.lab.trade;

import java.awt.image.BufferedImage;
import java.util.List;
import nephele.engine.measure.ErrorMap;

/**
 * The error of a setting.
 *
 * @param error in the subject's metric
 * @param figures further results, in the order of the subject's {@link Trade#figures}
 * @param picture the setting's picture; {@code null} if it has none
 * @param map the difference from the exact picture, bottom row first; {@code null} likewise
 */
public record Judgement(double error, List<Double> figures, BufferedImage picture, ErrorMap map) {
    /** Returns a judgement without a picture. */
    public static Judgement of(double error, Double... figures) {
        return new Judgement(error, List.of(figures), null, null);
    }
}
