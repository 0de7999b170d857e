package nephele.engine.level;

import nephele.engine.math.Vec3;

/**
 * The position and view direction of the player at tick 0. Yaw 0 looks along −z, positive to the left; pitch is
 * positive upwards.
 */
public record PlayerStart(
        @Written(required = true, spatial = Spatial.POINT) @Range Vec3 feet,
        @Written @Range double yawDegrees,
        @Written @Range(min = -90, max = 90) double pitchDegrees) {}
