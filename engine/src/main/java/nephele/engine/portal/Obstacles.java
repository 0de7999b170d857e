package nephele.engine.portal;

import org.joml.Vector3dc;

/** The geometry that stops a path: solids for a body, opaque ones for light. */
@FunctionalInterface
public interface Obstacles {
    /** No obstacles. */
    Obstacles NONE = (from, displacement) -> 1;

    /** Returns the free fraction of a displacement, 0 to 1; 1 without an obstacle. */
    double free(Vector3dc from, Vector3dc displacement);
}
