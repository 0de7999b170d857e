package nephele.workshop.prove.geometry;

import java.util.ArrayList;
import java.util.List;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/** Casts rays where rounding decides: at shared edges and corners, from surfaces, along the faces of boxes. */
public final class RayProof implements Proof {
    @Override
    public Claim claim() {
        return new Claim(
                "rays",
                "No ray passes between triangles that share an edge, hits the surface that it leaves, passes"
                        + " a wall 1 mm away, or misses a box that it hits in exact arithmetic.",
                "rays of each kind",
                1_000_000,
                100_000);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) {
        List<String> failures = new ArrayList<>();
        SharedEdges edges = new SharedEdges(failures);
        LeavingRays leaving = new LeavingRays(failures);
        ExactSlabs slabs = new ExactSlabs(failures);
        for (long unit = from; unit < from + count; unit++) {
            edges.cast(unit);
            leaving.cast(unit);
            slabs.cast(unit);
            progress.unitsDone(unit + 1 - from);
        }
        return ProofResult.of(
                count,
                failures,
                Figure.greatest("farthest hit from its plane", edges.greatestUlpsOffPlane(), "ulp of the extent"),
                Figure.sum("walls 1 mm on", leaving.walls(), ""),
                Figure.sum("boxes met", slabs.met(), ""));
    }
}
