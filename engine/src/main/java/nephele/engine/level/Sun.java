package nephele.engine.level;

import nephele.engine.math.Vec3;

/**
 * A directional light without a visible disc.
 *
 * @param directionTowardsSun any length but zero
 * @param irradiance linear RGB on a plane perpendicular to the beam; a Lambert surface sends albedo / π × irradiance × cos
 */
public record Sun(Vec3 directionTowardsSun, Vec3 irradiance, boolean castsShadow) {}
