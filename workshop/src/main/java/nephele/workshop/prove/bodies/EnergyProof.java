package nephele.workshop.prove.bodies;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.LongStream;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/**
 * Drops piles of boxes, balls and capsules, a third of them above or beside portals, and checks their energy. A unit is
 * a pile; its number is the seed.
 */
public final class EnergyProof implements Proof {
    /** The fraction of all piles that may exceed the limit of 1 mm. */
    private static final double MOST_LITTLE_GAINS = .001;
    /** The fraction of the piles without portals that may end awake. */
    private static final double MOST_AWAKE = .001;

    private static final int AT_ONCE = 64;

    private static final String PILES = "piles";
    private static final String VIOLATIONS = "violations";
    /** Piles with frozen bodies or advances cut short; neither gains energy, but both are failures. */
    private static final String FAULTY = "piles with faults";

    private static final String LITTLE = "violations at 1 mm";
    private static final String DEEP = "piles deeper than 1 cm";
    private static final String PLAIN = "piles without portals";
    private static final String AWAKE = "awake";

    @Override
    public Claim claim() {
        return new Claim(
                "energy",
                "Piles of one to four boxes, balls and capsules of 1 mm to 2.5 m and 1 g to 1 t, dropped for 10 s at"
                    + " 20 to 1000 ticks a second, a third of them at portals, seeds 0 to 99,999: E(t) is never above"
                    + " the least earlier E + 1e-5 of the greatest + m g 1 cm, and above it with 1 mm for at most 0.1"
                    + " %; from 1 s on none is deeper than 1 cm in a solid (every tenth tick); without portals at most"
                    + " 0.1 % end awake but for what rolls or spins.",
                "piles",
                100_000,
                2_000);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) {
        ProofResult result = ProofResult.NOTHING;
        for (long unit = from; unit < from + count; unit += AT_ONCE) {
            long end = Math.min(from + count, unit + AT_ONCE);
            List<ProofResult> some = LongStream.range(unit, end)
                    .parallel()
                    .mapToObj(EnergyProof::seen)
                    .toList();
            for (ProofResult one : some) {
                one.examples().forEach(progress::failed);
                result = result.and(one);
            }
            progress.unitsDone(end - from);
        }
        return result;
    }

    private static ProofResult seen(long number) {
        DroppedPileRun.Seen seen = DroppedPileRun.run(DroppedPile.of(number));
        boolean isFaulty = seen.faults() > 0;
        boolean isDeep = !(seen.deepestMetres() <= DroppedPileRun.DEEP_METRES);
        String where = "mm in pile " + number;
        List<Figure> figures = List.of(
                Figure.sum(PILES, 1, ""),
                Figure.sum(VIOLATIONS, seen.gains() ? 1 : 0, ""),
                Figure.sum(FAULTY, isFaulty ? 1 : 0, ""),
                Figure.sum(LITTLE, seen.gainsLittle() ? 1 : 0, ""),
                Figure.greatest("deepest", seen.deepestMetres() * 1000, where),
                Figure.sum(DEEP, isDeep ? 1 : 0, ""),
                Figure.greatest("deepest in another body", seen.deepestInBodyMetres() * 1000, where),
                Figure.sum(PLAIN, seen.hasPortals() ? 0 : 1, ""),
                Figure.sum(AWAKE, seen.rests() ? 0 : 1, ""),
                Figure.sum("bodies through portals", seen.crossings(), "times"));
        int failures = (seen.gains() ? 1 : 0) + (isFaulty ? 1 : 0) + (isDeep ? 1 : 0);
        return new ProofResult(1, failures, figures, seen.failures());
    }

    /** Judges the limits that are fractions of all piles. */
    @Override
    public ProofResult judged(ProofResult soFar) {
        List<String> failures = new ArrayList<>(soFar.examples());
        long more = judge(soFar, LITTLE, PILES, MOST_LITTLE_GAINS, failures)
                + judge(soFar, AWAKE, PLAIN, MOST_AWAKE, failures);
        return new ProofResult(soFar.units(), soFar.failures() + more, soFar.figures(), failures);
    }

    private static long judge(ProofResult result, String some, String of, double most, List<String> failures) {
        double count = result.value(some);
        double all = result.value(of);
        if (count <= most * all) {
            return 0;
        }
        failures.add(0, String.format(Locale.ROOT, "%s: %.0f of %.0f", some, count, all));
        return (long) count;
    }
}
