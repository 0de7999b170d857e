package nephele.engine.math;

/** Takes items as they were numbered when the {@link SpatialIndex} was built. */
@FunctionalInterface
public interface ItemVisitor {
    void item(int item);
}
