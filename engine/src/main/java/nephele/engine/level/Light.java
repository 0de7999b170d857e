package nephele.engine.level;

import nephele.engine.math.Vec3;

/** A lamp without extent. Radiant intensity is linear RGB; irradiance falls with the square of the distance. */
public sealed interface Light {
    String id();

    Vec3 position();

    Vec3 radiantIntensity();

    /** Beyond it nothing arrives; the fall-off is windowed so that it gets there smoothly. */
    double rangeMetres();

    boolean castsShadow();

    /** {@code "kind": "point"}. */
    record Point(String id, Vec3 position, Vec3 radiantIntensity, double rangeMetres, boolean castsShadow)
            implements Light {}

    /** {@code "kind": "spot"}; cones are half angles from the axis, full light inside the inner one. */
    record Spot(
            String id,
            Vec3 position,
            Vec3 direction,
            Vec3 radiantIntensity,
            double rangeMetres,
            double innerConeDegrees,
            double outerConeDegrees,
            boolean castsShadow)
            implements Light {}
}
