package nephele.workshop.prove.bodies;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/**
 * Runs the piles of boxes with which other engines were measured, 600 a family, each for ten seconds at 120 ticks a
 * second. The figures have the names of that comparison's columns. CPU time is one of them; therefore it uses a single
 * thread.
 */
public final class PilesProof implements Proof {
    private static final BoxPile.Family[] FAMILIES = BoxPile.Family.values();
    private static final long PILES_A_FAMILY = 600;
    /** The fraction of the piles that may remain awake, or fall although they could stand. */
    private static final double MOST_UNSETTLED = .01;

    private final int warmPiles;
    private boolean warm;

    /**
     * @param warmPiles number run before the first batch, so that the code is compiled: CPU time is compared with other
     *     engines'
     */
    public PilesProof(int warmPiles) {
        this.warmPiles = warmPiles;
    }

    @Override
    public Claim claim() {
        return new Claim(
                "piles",
                "Piles of boxes of 1 mm to 2.5 m and 1 g to 1 t gain no energy, sink into nothing, pass through"
                        + " nothing and stay in their room; of each family 99 of 100 come to rest, and 99 of 100 towers"
                        + " and loaded small cubes stand.",
                "piles",
                PILES_A_FAMILY * FAMILIES.length,
                300);
    }

    /** Runs units; a unit is a pile, and the families alternate. */
    @Override
    public ProofResult run(long from, long count, Progress progress) {
        warm();
        ProofResult result = ProofResult.NOTHING;
        for (long unit = from; unit < from + count; unit++) {
            BoxPile.Family family = FAMILIES[(int) (unit % FAMILIES.length)];
            result = result.and(BoxPileRun.run(family, (int) (unit / FAMILIES.length)));
            progress.unitsDone(unit + 1 - from);
        }
        return result;
    }

    private void warm() {
        for (int i = 0; i < warmPiles && !warm; i++) {
            BoxPileRun.run(FAMILIES[i % FAMILIES.length], i);
        }
        warm = true;
    }

    /**
     * Converts sums to fractions of the piles, and CPU time to time a step. Rest and standing are judged by their
     * fractions.
     */
    @Override
    public ProofResult judged(ProofResult soFar) {
        List<Figure> figures = new ArrayList<>();
        List<String> failures = new ArrayList<>(soFar.examples());
        long unsettled = 0;
        for (BoxPile.Family family : FAMILIES) {
            String of = family.word() + " ";
            double piles = soFar.value(of + "piles");
            for (Figure figure : soFar.figures()) {
                if (figure.name().startsWith(of)) {
                    figures.add(converted(figure, piles));
                }
            }
            unsettled += judge(soFar, of + "at_rest", piles, failures);
            unsettled += family == BoxPile.Family.DROP ? 0 : judge(soFar, of + "stands", piles, failures);
        }
        return new ProofResult(soFar.units(), soFar.failures() + unsettled, figures, failures);
    }

    private static Figure converted(Figure figure, double piles) {
        if (figure.name().endsWith(" cpu")) {
            double microseconds = 1e6 * figure.value() / (piles * BoxPileRun.STEPS);
            return Figure.sum(figure.name() + "_us_per_step", microseconds, "µs");
        }
        boolean isCount = figure.join() == Figure.Join.SUM && !figure.name().endsWith(" piles");
        return isCount ? Figure.sum(figure.name(), figure.value() / piles, "") : figure;
    }

    /** Returns the number of piles without the property if it exceeds the limit, else 0. */
    private static long judge(ProofResult result, String property, double piles, List<String> failures) {
        double without = piles - result.value(property);
        if (without <= MOST_UNSETTLED * piles) {
            return 0;
        }
        failures.add(String.format(Locale.ROOT, "%s: not %.0f of %.0f", property, without, piles));
        return (long) without;
    }
}
