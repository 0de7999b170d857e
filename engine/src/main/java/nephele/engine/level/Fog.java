package nephele.engine.level;

import nephele.engine.math.Vec3;

/** Homogeneous fog: radiance · (1 − exp(−extinction · distance)) over what lies behind. */
public record Fog(
        @Written(required = true, min = 0, max = 1e3) double extinctionPerMetre,
        @Written(required = true, min = 0, max = 1e9) Vec3 radiance) {}
