package nephele.engine.math;

import org.joml.Vector3d;

/** A map of space that keeps all lengths: a rotation with a translation, or a reflection. */
public interface Isometry {
    /** Maps a point in place. @return {@code p} */
    Vector3d point(Vector3d p);

    /** Maps a direction or a velocity in place. @return {@code v} */
    Vector3d direction(Vector3d v);

    /** Returns true if the map reverses handedness. */
    boolean isReflection();
}
