package nephele.lab.trade;

import java.util.List;
import java.util.OptionalInt;
import nephele.engine.measure.Interval;

/**
 * The evaluated measurements of a setting.
 *
 * @param cost CPU time in the subject's unit: the usual setting's median times {@code ratio}
 * @param wallNanos wall time of one run
 * @param ratio CPU time relative to the subject's usual setting, paired by rounds
 * @param bytes allocated for one counted item (a frame, a tick, …)
 * @param dominatedBy index of a setting that is better in one respect and worse in none; empty on the Pareto front
 */
public record SettingFindings(
        Setting setting,
        Interval cost,
        Interval wallNanos,
        Interval ratio,
        double bytes,
        double error,
        List<Double> figures,
        boolean hasPicture,
        OptionalInt dominatedBy) {
    public boolean isOnFront() {
        return dominatedBy.isEmpty();
    }
}
