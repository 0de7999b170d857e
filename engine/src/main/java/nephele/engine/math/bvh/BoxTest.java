package nephele.engine.math.bvh;

/**
 * A box predicate that selects the items of a {@link SpatialIndex} query. A box that passes must also pass in every box
 * that encloses it.
 */
@FunctionalInterface
public interface BoxTest {
    /** @param bounds minima and maxima, beginning at {@code at} */
    boolean passes(double[] bounds, int at);
}
