package nephele.lab.trade;

import java.util.List;
import java.util.OptionalInt;
import nephele.engine.measure.Interval;

/**
 * What is known of a setting.
 *
 * @param cost in the subject's unit, CPU: the usual setting's median times {@code ratio}
 * @param wallNanos of one run
 * @param ratio to the subject's usual setting, CPU, from rounds
 * @param bytes allocated for one of what is counted
 * @param dominatedBy the index of a setting that is better in one respect and worse in none
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
