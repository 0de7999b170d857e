package nephele.engine.math;

import org.joml.Vector3d;

/** A map of space that keeps all lengths: a rotation with a translation, or a reflection. */
public interface Isometry {
    /** Maps a point in place. @return {@code p} */
    Vector3d point(Vector3d p);

    /** Maps a direction or a velocity in place. @return {@code v} */
    Vector3d direction(Vector3d v);

    /** Returns true if the map reverses handedness. */
    default boolean isReflection() {
        return false;
    }

    /** Returns the mapped point. */
    default Vec3 point(Vec3 p) {
        return Vec3.of(point(p.toVector()));
    }

    /** Returns the mapped direction. */
    default Vec3 direction(Vec3 v) {
        return Vec3.of(direction(v.toVector()));
    }
}
