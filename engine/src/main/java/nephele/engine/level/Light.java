package nephele.engine.level;

import nephele.engine.math.Vec3;

/** A punctual light. Radiant intensity is linear RGB; irradiance falls with the square of the distance. */
public sealed interface Light {
    /** Upper bound of the depth pictures of all shadow-casting lights of a level. */
    int MOST_SHADOW_PICTURES = 512;

    /** Returns the id, unique among lights. */
    String id();

    /** Returns the position in metres. */
    Vec3 position();

    /** Returns the radiant intensity, linear RGB, in watts per steradian. */
    Vec3 radiantIntensity();

    /**
     * Returns the distance in metres beyond which the light has no effect; a window function brings the falloff
     * smoothly to zero there.
     */
    double rangeMetres();

    boolean castsShadow();

    /** Returns the name of the layer of lights that are dimmed and switched together; {@code null} for none. */
    String layer();

    /** Returns this light with its intensity multiplied by a gain. */
    default Light dimmed(double gain) {
        Vec3 intensity = radiantIntensity().scaled(gain);
        return this instanceof Spot spot
                ? RecordCopy.with(spot, "radiantIntensity", intensity)
                : RecordCopy.with((Point) this, "radiantIntensity", intensity);
    }

    /**
     * Returns the number of depth pictures of its shadow: six faces of a cube, or one along the axis of a spot up to
     * 80° wide.
     */
    default int shadowPictures() {
        return this instanceof Spot spot && spot.outerConeDegrees() <= 80 ? 1 : 6;
    }

    /** {@code "kind": "point"}. */
    record Point(
            @Written(required = true, text = TextKind.ID) String id,
            @Written(required = true, spatial = Spatial.POINT) @Range Vec3 position,
            @Written(required = true, prototype = "[20, 19, 17]") @Range(min = 0, max = 1e9) Vec3 radiantIntensity,
            @Written(absent = "20", spatial = Spatial.LENGTH) @Range(min = 1e-3, max = 1e7, shape = Range.Shape.OR_ZERO)
                    double rangeMetres,
            @Written(absent = "true") boolean castsShadow,
            @Written(text = TextKind.ID) String layer)
            implements Light {
        /** Makes a light of no layer. */
        public Point(String id, Vec3 position, Vec3 radiantIntensity, double rangeMetres, boolean castsShadow) {
            this(id, position, radiantIntensity, rangeMetres, castsShadow, null);
        }
    }

    /** {@code "kind": "spot"}; cone angles are half angles from the axis, with full intensity inside the inner cone. */
    record Spot(
            @Written(required = true, text = TextKind.ID) String id,
            @Written(required = true, spatial = Spatial.POINT) @Range Vec3 position,
            @Written(required = true, spatial = Spatial.DIRECTION, prototype = "[0, -1, 0]")
                    @Range(min = 1e-9, shape = Range.Shape.DIRECTION)
                    Vec3 direction,
            @Written(required = true, prototype = "[20, 19, 17]") @Range(min = 0, max = 1e9) Vec3 radiantIntensity,
            @Written(absent = "20", spatial = Spatial.LENGTH) @Range(min = 1e-3, max = 1e7, shape = Range.Shape.OR_ZERO)
                    double rangeMetres,
            @Written(absent = "20") @Range(min = 0, max = 90) double innerConeDegrees,
            @Written(absent = "30") @Range(min = 0.1, max = 90) double outerConeDegrees,
            @Written(absent = "true") boolean castsShadow,
            @Written(text = TextKind.ID) String layer)
            implements Light {
        /** Makes a light of no layer. */
        public Spot(
                String id,
                Vec3 position,
                Vec3 direction,
                Vec3 radiantIntensity,
                double rangeMetres,
                double innerConeDegrees,
                double outerConeDegrees,
                boolean castsShadow) {
            this(
                    id,
                    position,
                    direction,
                    radiantIntensity,
                    rangeMetres,
                    innerConeDegrees,
                    outerConeDegrees,
                    castsShadow,
                    null);
        }
    }
}
