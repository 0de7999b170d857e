package nephele.engine.math.bvh;

/** Receives items by their index in the list from which the {@link SpatialIndex} was built. */
@FunctionalInterface
public interface ItemVisitor {
    void item(int item);
}
