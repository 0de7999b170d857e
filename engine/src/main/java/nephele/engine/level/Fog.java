package nephele.engine.level;

import nephele.engine.math.Vec3;

/** Homogeneous fog: radiance · (1 − exp(−extinction · distance)) over what lies behind. */
public record Fog(double extinctionPerMetre, Vec3 radiance) {}
