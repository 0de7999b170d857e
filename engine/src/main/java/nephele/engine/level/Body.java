package nephele.engine.level;

import nephele.engine.math.Vec3;

/** A movable rigid body. */
public sealed interface Body {
    String id();

    /** {@code "kind": "box"}. */
    record Box(String id, Vec3 centre, Vec3 size, double massKilograms, String material) implements Body {}

    /** {@code "kind": "sphere"}. */
    record Sphere(String id, Vec3 centre, double radiusMetres, double massKilograms, String material) implements Body {}
}
