package nephele.lab.prove;

import java.util.ArrayList;
import java.util.List;

/** Casts rays where rounding decides: at shared edges and corners, from surfaces, along the faces of boxes. */
public final class RayProof implements Proof {
    @Override
    public String name() {
        return "rays";
    }

    @Override
    public String claim() {
        return "No ray slips between triangles that share an edge, meets the surface it leaves, skips a wall 1 mm on,"
                + " or misses a box that exact arithmetic meets.";
    }

    @Override
    public String unit() {
        return "rays of each kind";
    }

    @Override
    public long fullCount() {
        return 1_000_000;
    }

    @Override
    public long batch() {
        return 100_000;
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
            if (unit % 1000 == 999) {
                progress.unitsDone(unit + 1 - from);
            }
        }
        return new ProofResult(
                count,
                failures.size(),
                List.of(
                        Figure.greatest(
                                "farthest hit from its plane", edges.greatestUlpsOffPlane(), "ulp of the extent"),
                        Figure.sum("walls 1 mm on", leaving.walls(), ""),
                        Figure.sum("boxes met", slabs.met(), "")),
                failures);
    }
}
