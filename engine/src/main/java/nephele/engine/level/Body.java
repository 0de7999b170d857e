package nephele.engine.level;

import nephele.engine.math.Vec3;

/** A movable rigid body. */
public sealed interface Body {
    String id();

    /** {@code "kind": "box"}. */
    record Box(
            @Written(required = true, text = TextFormat.Rule.ID) String id,
            @Written(required = true) Vec3 centre,
            @Written(required = true, min = 1e-4) Vec3 size,
            @Written(required = true, min = 1e-6) double massKilograms,
            @Written(text = TextFormat.Rule.ID) String material)
            implements Body {}

    /** {@code "kind": "sphere"}. */
    record Sphere(
            @Written(required = true, text = TextFormat.Rule.ID) String id,
            @Written(required = true) Vec3 centre,
            @Written(required = true, min = 1e-4) double radiusMetres,
            @Written(required = true, min = 1e-6) double massKilograms,
            @Written(text = TextFormat.Rule.ID) String material)
            implements Body {}
}
