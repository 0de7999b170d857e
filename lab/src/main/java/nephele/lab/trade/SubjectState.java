package nephele.lab.trade;

import java.util.ArrayList;
import java.util.List;

/**
 * The measurements of a subject so far.
 *
 * @param judged the settings judged so far, in order
 * @param rounds for each round of timing, the costs of all settings
 */
public record SubjectState(List<Judged> judged, List<List<Cost>> rounds) {
    public static final SubjectState NOTHING = new SubjectState(List.of(), List.of());

    /**
     * The part of a judgement that is saved; its pictures are saved beside the report.
     *
     * @param figures see {@link Trade#figures}
     */
    public record Judged(double error, List<Double> figures, boolean hasPicture) {}

    public SubjectState with(Judged next) {
        List<Judged> more = new ArrayList<>(judged);
        more.add(next);
        return new SubjectState(List.copyOf(more), rounds);
    }

    public SubjectState withRound(List<Cost> next) {
        List<List<Cost>> more = new ArrayList<>(rounds);
        more.add(next);
        return new SubjectState(judged, List.copyOf(more));
    }

    public boolean isComplete(Trade trade, int wantedRounds) {
        return judged.size() == trade.settings().size() && rounds.size() >= wantedRounds;
    }
}
