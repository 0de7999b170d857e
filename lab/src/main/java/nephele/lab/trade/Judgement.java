package nephele.lab.trade;

import java.awt.image.BufferedImage;
import java.util.List;
import nephele.engine.measure.ErrorMap;

/**
 * How wrong a setting is.
 *
 * @param error in the subject's metric
 * @param figures besides it, in the order of the subject's {@link Trade#figures}
 * @param shown what it looks like; {@code null} where there is nothing to see
 * @param map where it differs from the exact picture, the bottom row first; {@code null} likewise
 */
public record Judgement(double error, List<Double> figures, BufferedImage shown, ErrorMap map) {
    /** Without a picture. */
    public static Judgement of(double error, Double... figures) {
        return new Judgement(error, List.of(figures), null, null);
    }
}
