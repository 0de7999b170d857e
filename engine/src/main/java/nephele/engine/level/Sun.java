package nephele.engine.level;

import nephele.engine.math.Vec3;

/**
 * A directional light without a visible disc.
 *
 * @param directionTowardsSun any length but zero; {@code null} for that of the hour, under an atmosphere only
 * @param irradiance linear RGB on a plane perpendicular to the light; a Lambertian surface reflects albedo / π ×
 * irradiance × cos
 */
public record Sun(
        @Written(prototype = "[1, 2, 1]") @Range(min = 1e-9, shape = Range.Shape.DIRECTION) Vec3 directionTowardsSun,
        @Written(required = true) @Range(min = 0, max = 1e9) Vec3 irradiance,
        @Written(absent = "true") boolean castsShadow) {}
