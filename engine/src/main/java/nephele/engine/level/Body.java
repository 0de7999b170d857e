package nephele.engine.level;

import nephele.engine.math.Vec3;

/**
 * A movable rigid body of uniform density, upright at the start. The friction of two touching bodies is the geometric
 * mean of their coefficients; their restitution is the greater of the two.
 */
public sealed interface Body {
    /** Returns the id, unique among bodies. */
    String id();

    /** Returns the centre of mass at the start, in metres. */
    Vec3 centre();

    /** Returns the mass, greater than 0. */
    double massKilograms();

    /** Returns the id of the material, or {@code null} for the default grey. */
    String material();

    /** Returns Coulomb's coefficient of friction. */
    double friction();

    /** Returns the coefficient of restitution: the ratio of separating to approaching speed. */
    double restitution();

    /** Returns this body with another material. */
    Body withMaterial(String other);

    /** {@code "kind": "box"}. */
    record Box(
            @Written(required = true, text = TextKind.ID) String id,
            @Written(required = true, spatial = Spatial.POINT) @Range Vec3 centre,
            @Written(required = true, spatial = Spatial.EXTENT, prototype = "[0.6, 0.6, 0.6]") @Range(min = 1e-4)
                    Vec3 size,
            @Written(required = true, prototype = "30") @Range(min = 1e-6) double massKilograms,
            @Written(text = TextKind.ID, refersTo = "materials") String material,
            @Written(absent = "0.6") @Range(min = 0, max = 10) double friction,
            @Written @Range(min = 0, max = 1) double restitution)
            implements Body {
        @Override
        public Body withMaterial(String other) {
            return new Box(id, centre, size, massKilograms, other, friction, restitution);
        }
    }

    /** {@code "kind": "sphere"}. */
    record Sphere(
            @Written(required = true, text = TextKind.ID) String id,
            @Written(required = true, spatial = Spatial.POINT) @Range Vec3 centre,
            @Written(required = true, spatial = Spatial.LENGTH, prototype = "0.3") @Range(min = 1e-4)
                    double radiusMetres,
            @Written(required = true, prototype = "30") @Range(min = 1e-6) double massKilograms,
            @Written(text = TextKind.ID, refersTo = "materials") String material,
            @Written(absent = "0.6") @Range(min = 0, max = 10) double friction,
            @Written @Range(min = 0, max = 1) double restitution)
            implements Body {
        @Override
        public Body withMaterial(String other) {
            return new Sphere(id, centre, radiusMetres, massKilograms, other, friction, restitution);
        }
    }

    /** {@code "kind": "capsule"}: its axis stands upright at the start; {@code heightMetres} includes both caps. */
    record Capsule(
            @Written(required = true, text = TextKind.ID) String id,
            @Written(required = true, spatial = Spatial.POINT) @Range Vec3 centre,
            @Written(required = true, spatial = Spatial.LENGTH, prototype = "0.3") @Range(min = 1e-4)
                    double radiusMetres,
            @Written(required = true, spatial = Spatial.LENGTH, prototype = "1.2") @Range(min = 2e-4)
                    double heightMetres,
            @Written(required = true, prototype = "30") @Range(min = 1e-6) double massKilograms,
            @Written(text = TextKind.ID, refersTo = "materials") String material,
            @Written(absent = "0.6") @Range(min = 0, max = 10) double friction,
            @Written @Range(min = 0, max = 1) double restitution)
            implements Body {
        @Override
        public Body withMaterial(String other) {
            return new Capsule(id, centre, radiusMetres, heightMetres, massKilograms, other, friction, restitution);
        }
    }
}
