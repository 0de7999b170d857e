package nephele.workshop.prove.geometry;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.model.bound.Bound;
import nephele.lab.trade.subject.ModelPairs;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/** Asks all bounding volumes about pairs of models: one without a contact is right. */
public final class CollisionBoundsProof implements Proof {
    @Override
    public Claim claim() {
        return new Claim(
                "collision-bounds",
                "Where a sphere, an axis-aligned box, an oriented box or a tree of boxes reports no contact of two"
                        + " models, no triangles of them touch, and a finer volume reports none either.",
                "pairs",
                1_000_000,
                100_000);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) {
        var pairs = new ModelPairs();
        List<String> failures = new ArrayList<>();
        long[] reported = new long[Bound.values().length];
        for (long number = from; number < from + count; number++) {
            ModelPairs.Pair pair = pairs.pair(number);
            boolean[] touch = new boolean[reported.length];
            for (Bound bound : Bound.values()) {
                touch[bound.ordinal()] = pair.touch(bound);
                reported[bound.ordinal()] += touch[bound.ordinal()] ? 1 : 0;
            }
            if (isWrong(touch)) {
                failures.add("pair " + number + ": " + pair.names());
            }
            progress.unitsDone(number + 1 - from);
        }
        List<Figure> figures = new ArrayList<>();
        for (Bound bound : Bound.values()) {
            figures.add(Figure.sum("contacts by " + words(bound), reported[bound.ordinal()], ""));
        }
        return ProofResult.of(count, failures, figures);
    }

    /** Returns whether a volume reports none where one reports a contact that lies within it. */
    private static boolean isWrong(boolean[] touch) {
        boolean isContact = touch[Bound.TRIANGLES.ordinal()];
        boolean isOfTree = touch[Bound.TREE.ordinal()];
        boolean isOfBox = touch[Bound.ORIENTED_BOX.ordinal()];
        return isContact && !isOfTree
                || isContact && !touch[Bound.SPHERE.ordinal()]
                || isOfTree && !isOfBox
                || isOfBox && !touch[Bound.BOX.ordinal()];
    }

    private static String words(Bound bound) {
        return switch (bound) {
            case SPHERE -> "sphere";
            case BOX -> "axis aligned box";
            case ORIENTED_BOX -> "oriented box";
            case TREE -> "hierarchy";
            case TRIANGLES -> "triangles";
        };
    }
}
