package nephele.workshop.prove.geometry;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.collision.Collider;
import nephele.engine.collision.Separation;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;
import org.joml.Vector3d;

/**
 * Compares the separation of pairs of a shape and a solid with brute force, where rounding decides.
 *
 * <p>Two right answers may differ: GJK bounds the distance d by the support along a direction v that is a difference of
 * coordinates of size L, so v is off by about εL and its direction by εL / d (ε = 2⁻⁵³). Over an extent L that lowers
 * the bound by εL² / d, but never below contact, where separating axes are used instead. The loss is thus at most
 * min(d, εL² / d) ≤ √ε L = 1.1e-8 L, and always towards "nearer". A flat simplex solves for v with a few times that
 * error, and corners of solids are welded within 1e-9 L: {@link #BAND} leaves room for both.
 */
public final class SeparationProof implements Proof {
    /** Fraction of a pair's extent within which both contact and separation are right answers. */
    private static final double BAND = 1e-7;

    @Override
    public Claim claim() {
        return new Claim(
                "separation",
                "Random, touching, parallel, degenerate, tiny and huge shapes overlap or miss a solid as in the"
                        + " brute-force test, at the same distance; a translation by the depth separates overlapping"
                        + " shapes, and a shorter one does not.",
                "pairs",
                1_000_000,
                100_000);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) {
        Comparison comparison = new Comparison();
        for (long unit = from; unit < from + count; unit++) {
            comparison.compare(unit, SeparationSample.of(unit));
            progress.unitsDone(unit + 1 - from);
        }
        return ProofResult.of(
                count,
                comparison.failures,
                Figure.sum("meeting", comparison.intersection, "pairs"),
                Figure.sum("apart by less than 1e-7 of their extent", comparison.close, "pairs"),
                Figure.greatest("nearer than the truth", comparison.nearer, "of the extent"),
                Figure.greatest("farther than the truth", comparison.farther, "of the extent"),
                Figure.greatest("depth that does not part", comparison.stuck, "of the extent"));
    }

    /** The results so far. */
    private static final class Comparison {
        private final List<String> failures = new ArrayList<>();
        private final Separation separation = new Separation();
        private long intersection;
        private long close;
        private double nearer;
        private double farther;
        private double stuck;

        void compare(long unit, SeparationSample pair) {
            double extent = pair.extentMetres();
            separation.measure(pair.hull(), pair.at().x, pair.at().y, pair.at().z, new Collider("", pair.solid()));
            double measured = separation.metres() + pair.radiusMetres();
            double reference = pair.distance(new Vector3d());
            if (reference > 0) {
                close += reference < BAND * extent ? 1 : 0;
                nearer = Math.max(nearer, (reference - measured) / extent);
            } else {
                intersection++;
            }
            farther = Math.max(farther, (measured - reference) / extent);
            boolean agrees = reference > 0
                    ? Math.abs(measured - reference) <= BAND * extent
                    : measured <= BAND * extent && parts(pair, measured, extent) && least(unit, pair, measured, extent);
            if (!agrees) {
                failures.add("pair " + unit + ": " + measured + " m, by brute force " + reference + " m, over " + extent
                        + " m");
            }
        }

        /** Returns true if a core that moves out by its depth and the band no longer touches the solid. */
        private boolean parts(SeparationSample pair, double measured, double extent) {
            double metres = Math.max(0, -measured) + 2 * BAND * extent;
            var normal = new Vector3d(separation.normal());
            double gap = pair.distance(normal.mul(metres));
            stuck = Math.max(stuck, 2 * BAND - gap / extent);
            return gap > BAND * extent;
        }

        /** Returns true if no shorter displacement along the normal of a face separates the pair. */
        private boolean least(long unit, SeparationSample pair, double measured, double extent) {
            double metres = -measured - 2 * BAND * extent;
            return metres <= 0 || pair.distance(pair.faceNormal(unit).mul(metres)) <= BAND * extent;
        }
    }
}
