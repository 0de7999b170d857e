package nephele.lab.generate;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import org.joml.Vector3dc;

/** Chooses where on a branching structure leaves are. */
final class Lobes {
    /** The depth in a lobe at which its leaves hide a tip. */
    private static final double COVERED_DEPTH = 0.75;

    private Lobes() {}

    /**
     * Returns lobes around tips of branches such that every tip is in one: each lobe hangs on a branch and no branch ends
     * bare.
     */
    static List<Clump> atTips(Skeleton skeleton, Function<Vector3dc, Clump> lobe) {
        List<Clump> lobes = new ArrayList<>();
        for (int tip : skeleton.tips()) {
            Vector3dc at = skeleton.point(tip);
            if (lobes.stream().allMatch(other -> other.depth(at) > COVERED_DEPTH)) {
                lobes.add(lobe.apply(at));
            }
        }
        return lobes;
    }
}
