package nephele.workshop.prove.proof;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.LongFunction;

/**
 * The result of a range of units.
 *
 * @param units number of units run
 * @param failures number of units that refuted the claim
 * @param figures measured numbers, in the order in which they are reported
 * @param examples the first few failures in words, with the unit's number
 */
public record ProofResult(long units, long failures, List<Figure> figures, List<String> examples) {
    public static final ProofResult NOTHING = new ProofResult(0, 0, List.of(), List.of());
    private static final int EXAMPLES_KEPT = 10;

    public ProofResult {
        figures = List.copyOf(figures);
        examples = List.copyOf(examples.subList(0, Math.min(examples.size(), EXAMPLES_KEPT)));
    }

    /** Returns a result in which each failure is described in words. */
    public static ProofResult of(long units, List<String> failures, List<Figure> figures) {
        return new ProofResult(units, failures.size(), figures, failures);
    }

    public static ProofResult of(long units, List<String> failures, Figure... figures) {
        return of(units, failures, List.of(figures));
    }

    /**
     * Judges units one after another.
     *
     * @param progress told after each of them
     * @return the results of all as one
     */
    public static ProofResult ofUnits(
            long from, long count, Proof.Progress progress, LongFunction<ProofResult> judged) {
        ProofResult result = NOTHING;
        for (long unit = from; unit < from + count; unit++) {
            result = result.and(judged.apply(unit));
            progress.unitsDone(unit + 1 - from);
        }
        return result;
    }

    public boolean holds() {
        return failures == 0;
    }

    /** Returns this range and another one as one result; figures are joined by name. */
    public ProofResult and(ProofResult other) {
        var joined = new ArrayList<Figure>();
        for (var figure : figures) {
            joined.add(other.figure(figure.name()).map(figure::joined).orElse(figure));
        }
        for (var figure : other.figures) {
            if (figure(figure.name()).isEmpty()) {
                joined.add(figure);
            }
        }
        var allExamples = new ArrayList<>(examples);
        allExamples.addAll(other.examples);
        return new ProofResult(units + other.units, failures + other.failures, joined, allExamples);
    }

    public Optional<Figure> figure(String name) {
        return figures.stream().filter(figure -> figure.name().equals(name)).findFirst();
    }

    /** Returns the number of a figure; 0 if there is none. */
    public double value(String name) {
        return figure(name).map(Figure::value).orElse(0.0);
    }
}
