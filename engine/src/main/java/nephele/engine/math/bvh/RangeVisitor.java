package nephele.engine.math.bvh;

/** Receives runs of slots of a {@link SpatialIndex}, nearest first. */
@FunctionalInterface
public interface RangeVisitor {
    /** @param end one past the last slot */
    void range(int first, int end);
}
