package nephele.workshop.prove.portals;

import java.util.ArrayList;
import java.util.List;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.ProofResult;

/** The results of a range of crossings. */
final class CrossingTally {
    private static final int MOST_EXAMPLES = 10;

    private long through;
    private long without;
    private long escaped;
    private long stuck;
    private double deepestPlayer;
    private double deepestBody;
    private final List<String> examples = new ArrayList<>();

    void through() {
        through++;
    }

    void without() {
        without++;
    }

    void escaped(String what) {
        escaped++;
        fail(what);
    }

    void stuck(String what) {
        stuck++;
        fail(what);
    }

    void playerDepth(double metres) {
        deepestPlayer = Math.max(deepestPlayer, metres);
    }

    void bodyDepth(double metres) {
        deepestBody = Math.max(deepestBody, metres);
    }

    private void fail(String what) {
        if (examples.size() < MOST_EXAMPLES) {
            examples.add(what);
        }
    }

    ProofResult result(long count) {
        return new ProofResult(
                count,
                escaped + stuck,
                List.of(
                        Figure.sum("crossings", through, ""),
                        Figure.sum("units without a crossing", without, ""),
                        Figure.sum("out of the room", escaped, ""),
                        Figure.sum("in a solid", stuck, ""),
                        Figure.greatest("deepest point of a player in a solid", deepestPlayer * 1000, "mm"),
                        Figure.greatest("deepest point of a body in a solid", deepestBody * 1000, "mm")),
                examples);
    }
}
