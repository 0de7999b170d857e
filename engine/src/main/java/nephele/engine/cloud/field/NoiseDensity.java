package nephele.engine.cloud.field;

/**
 * A density of 0 to 1 that follows from noise. Coordinates are metres from the pattern's origin, which is at the base
 * of the cloud.
 */
public interface NoiseDensity {
    double at(double x, double y, double z);

    /** Returns true if the density is known to be zero everywhere. */
    boolean isEmpty();

    /** Returns an upper bound of the density in a box, given by its centre and half its sides. */
    double greatest(double x, double y, double z, double halfX, double halfY, double halfZ);
}
