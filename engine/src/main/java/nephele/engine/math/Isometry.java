package nephele.engine.math;

import org.joml.Vector3d;

/** A map of space that keeps all lengths: a rotation and a shift, or a reflection. */
public interface Isometry {
    /** Maps a point in place. @return {@code p} */
    Vector3d point(Vector3d p);

    /** Maps a direction or a velocity in place. @return {@code v} */
    Vector3d direction(Vector3d v);

    /** Whether it exchanges left and right. */
    boolean isReflection();
}
