package nephele.lab.trade.subject;

import java.util.List;
import java.util.stream.LongStream;
import nephele.engine.model.bound.Bound;
import nephele.lab.trade.CostMetric;
import nephele.lab.trade.ErrorMetric;
import nephele.lab.trade.Experiment;
import nephele.lab.trade.Judgement;
import nephele.lab.trade.Setting;
import nephele.lab.trade.Trade;

/** The contact of two models by their bounding volumes against that of their triangles. */
public final class CollisionSubject implements Experiment {
    private static final int QUESTIONS = 20_000;
    private static final int TIMED = 2_000;

    public static final Trade TRADE = new Trade(
            "collision",
            new Trade.Text(
                    "Contact by bounding volumes",
                    "A volume around a model is quick to test and reports contacts where there are none. Pairs of the"
                            + " models of the sample, turned at random, so far apart that their spheres nearly touch or"
                            + " overlap. A model within another one touches it by its volume, not by its surface.",
                    "every pair of triangles whose boxes touch"),
            List.of(),
            List.of(
                    new Setting("sphere", "one distance"),
                    new Setting("axisAlignedBox", "along the world's axes, around the turned box of the model"),
                    new Setting("orientedBox", "turned with the model"),
                    new Setting("hierarchy", "a tree of oriented boxes, down to one triangle each"),
                    new Setting("triangles", "the surface itself, found through the tree")),
            4,
            new ErrorMetric("of pairs apart, reported as a contact", "%", 0.05, 0.5),
            List.of("reported, %", "contacts missed"),
            new CostMetric("CPU a pair", "µs", 1e3, TIMED, CostMetric.Clock.THREAD),
            null,
            site -> new CollisionSubject());

    private final ModelPairs pairs = new ModelPairs();
    private final List<ModelPairs.Pair> timed =
            LongStream.range(0, TIMED).mapToObj(pairs::pair).toList();
    /** Uses the result, so that the compiler cannot eliminate the timed code. */
    private int touching;

    private CollisionSubject() {}

    @Override
    public Judgement judge(int setting) {
        int apart = 0;
        int reported = 0;
        int falsely = 0;
        int missed = 0;
        for (int question = 0; question < QUESTIONS; question++) {
            ModelPairs.Pair pair = pairs.pair(question);
            boolean isReported = pair.touch(Bound.values()[setting]);
            boolean isContact = pair.touch(Bound.TRIANGLES);
            apart += isContact ? 0 : 1;
            reported += isReported ? 1 : 0;
            falsely += isReported && !isContact ? 1 : 0;
            missed += isContact && !isReported ? 1 : 0;
        }
        return Judgement.of(100.0 * falsely / apart, 100.0 * reported / QUESTIONS, (double) missed);
    }

    @Override
    public void run(int setting) {
        Bound bound = Bound.values()[setting];
        for (ModelPairs.Pair pair : timed) {
            touching += pair.touch(bound) ? 1 : 0;
        }
    }
}
