package nephele.engine.math;

/** Which boxes a query of {@link SpatialIndex} is about; one that passes must pass in every box around it as well. */
@FunctionalInterface
public interface BoxTest {
    /** @param bounds minima and maxima from {@code at} on */
    boolean passes(double[] bounds, int at);
}
