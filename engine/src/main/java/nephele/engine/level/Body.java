package nephele.engine.level;

import nephele.engine.math.Vec3;

/**
 * A movable rigid body of even density, upright at the start. Two bodies rub by the geometric mean of their frictions
 * and bounce by the greater restitution.
 */
public sealed interface Body {
    String id();

    /** The centre of mass. */
    Vec3 centre();

    double massKilograms();

    /** Id, or {@code null} for the default grey. */
    String material();

    /** Coulomb's coefficient. */
    double friction();

    /** Share of the approach speed that a bounce gives back. */
    double restitution();

    /** {@code "kind": "box"}. */
    record Box(
            @Written(required = true, text = TextRule.ID) String id,
            @Written(required = true) Vec3 centre,
            @Written(required = true, min = 1e-4) Vec3 size,
            @Written(required = true, min = 1e-6) double massKilograms,
            @Written(text = TextRule.ID) String material,
            @Written(absent = "0.6", min = 0, max = 10) double friction,
            @Written(min = 0, max = 1) double restitution)
            implements Body {}

    /** {@code "kind": "sphere"}. */
    record Sphere(
            @Written(required = true, text = TextRule.ID) String id,
            @Written(required = true) Vec3 centre,
            @Written(required = true, min = 1e-4) double radiusMetres,
            @Written(required = true, min = 1e-6) double massKilograms,
            @Written(text = TextRule.ID) String material,
            @Written(absent = "0.6", min = 0, max = 10) double friction,
            @Written(min = 0, max = 1) double restitution)
            implements Body {}

    /** {@code "kind": "capsule"}: its axis stands upright at the start; {@code heightMetres} includes both caps. */
    record Capsule(
            @Written(required = true, text = TextRule.ID) String id,
            @Written(required = true) Vec3 centre,
            @Written(required = true, min = 1e-4) double radiusMetres,
            @Written(required = true, min = 2e-4) double heightMetres,
            @Written(required = true, min = 1e-6) double massKilograms,
            @Written(text = TextRule.ID) String material,
            @Written(absent = "0.6", min = 0, max = 10) double friction,
            @Written(min = 0, max = 1) double restitution)
            implements Body {}
}
