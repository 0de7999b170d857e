package nephele.engine.measure;

import java.util.List;
import java.util.OptionalInt;
import java.util.stream.IntStream;

/** Which of several choices are worth having: none other costs at most as much and errs at most as much, one of them less. */
public final class ParetoFront {
    private final List<Choice> choices;

    /** Smaller is better in both. */
    public record Choice(double cost, double error) {
        public Choice {
            if (!Double.isFinite(cost) || !Double.isFinite(error)) {
                throw new IllegalArgumentException(
                        "a choice needs a finite cost and error, not " + cost + ", " + error);
            }
        }

        boolean dominates(Choice other) {
            return cost <= other.cost && error <= other.error && (cost < other.cost || error < other.error);
        }
    }

    public ParetoFront(List<Choice> choices) {
        this.choices = List.copyOf(choices);
    }

    public boolean holds(int index) {
        return dominating(index).isEmpty();
    }

    /** The most accurate choice that dominates this one, and of these the cheapest; empty on the front. */
    public OptionalInt dominating(int index) {
        return IntStream.range(0, choices.size())
                .filter(other -> choices.get(other).dominates(choices.get(index)))
                .reduce((a, b) -> isBetter(choices.get(b), choices.get(a)) ? b : a);
    }

    private static boolean isBetter(Choice a, Choice b) {
        return a.error < b.error || a.error == b.error && a.cost < b.cost;
    }
}
