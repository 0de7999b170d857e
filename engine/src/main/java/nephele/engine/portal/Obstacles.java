package nephele.engine.portal;

import org.joml.Vector3dc;

/** What stops a path: solids for a body, opaque ones for light. */
@FunctionalInterface
public interface Obstacles {
    /** Nothing anywhere. */
    Obstacles NONE = (from, way) -> 1;

    /** How much of the way is free, 0 to 1; 1 when nothing is in it. */
    double free(Vector3dc from, Vector3dc way);
}
