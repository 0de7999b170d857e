package nephele.engine.level;

import nephele.engine.math.Vec3;

/**
 * An upright cylinder that ends the level: the first tick with the player's centre inside is the end. It is drawn as a
 * curtain of light along its side.
 *
 * @param feet centre of the cylinder's base, in metres
 */
public record Exit(
        @Written(required = true, text = TextKind.ID) String id,
        @Written(required = true, spatial = Spatial.POINT) @Range Vec3 feet,
        @Written(absent = "1", spatial = Spatial.LENGTH) @Range(min = 0.1, max = 1000) double radiusMetres,
        @Written(absent = "2", spatial = Spatial.LENGTH) @Range(min = 0.1, max = 1000) double heightMetres) {
    /** Returns true if a point is inside; the base and the side belong to the inside. */
    public boolean contains(Vec3 point) {
        double x = point.x() - feet.x();
        double z = point.z() - feet.z();
        double above = point.y() - feet.y();
        return above >= 0 && above <= heightMetres && x * x + z * z <= radiusMetres * radiusMetres;
    }
}
