package nephele.engine.level;

import nephele.engine.math.Vec3;

/** Where the player stands at tick 0. Yaw 0 looks along −z, positive to the left; pitch positive upwards. */
public record PlayerStart(Vec3 feet, double yawDegrees, double pitchDegrees) {}
