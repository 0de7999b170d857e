package nephele.engine.level;

import nephele.engine.math.Vec3;

/**
 * A sphere around a place of the level that the player should see or be at.
 *
 * @param position its centre, in metres
 */
public record Place(
        @Written(required = true, spatial = Spatial.POINT) @Range Vec3 position,
        @Written(absent = "2", spatial = Spatial.LENGTH) @Range(min = 0.1, max = 10_000) double radiusMetres) {
    /** Returns true if a point is inside; the surface belongs to the inside. */
    public boolean contains(Vec3 point) {
        return point.minus(position).length() <= radiusMetres;
    }
}
