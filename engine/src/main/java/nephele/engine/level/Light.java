package nephele.engine.level;

import nephele.engine.math.Vec3;

/** A lamp without extent. Radiant intensity is linear RGB; irradiance falls with the square of the distance. */
public sealed interface Light {
    /** Depth pictures that all casting lamps of a level share. */
    int MOST_SHADOW_PICTURES = 512;

    String id();

    Vec3 position();

    Vec3 radiantIntensity();

    /** Beyond it nothing arrives; the fall-off is windowed so that it gets there smoothly. */
    double rangeMetres();

    boolean castsShadow();

    /** Depth pictures that its shadow takes: the six faces of a cube, or one along the axis of a spot up to 80° wide. */
    default int shadowPictures() {
        return this instanceof Spot spot && spot.outerConeDegrees() <= 80 ? 1 : 6;
    }

    /** {@code "kind": "point"}. */
    record Point(
            @Written(required = true, text = TextRule.ID) String id,
            @Written(required = true) Vec3 position,
            @Written(required = true, min = 0, max = 1e9) Vec3 radiantIntensity,
            @Written(absent = "20", min = 0) double rangeMetres,
            @Written(absent = "true") boolean castsShadow)
            implements Light {}

    /** {@code "kind": "spot"}; cones are half angles from the axis, full light inside the inner one. */
    record Spot(
            @Written(required = true, text = TextRule.ID) String id,
            @Written(required = true) Vec3 position,
            @Written(required = true) Vec3 direction,
            @Written(required = true, min = 0, max = 1e9) Vec3 radiantIntensity,
            @Written(absent = "20", min = 0) double rangeMetres,
            @Written(absent = "20", min = 0, max = 90) double innerConeDegrees,
            @Written(absent = "30", min = 0.1, max = 90) double outerConeDegrees,
            @Written(absent = "true") boolean castsShadow)
            implements Light {}
}
