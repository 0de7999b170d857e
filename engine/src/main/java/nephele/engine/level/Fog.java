package nephele.engine.level;

import nephele.engine.math.Vec3;

/**
 * Homogeneous, endless fog: radiance · (1 − exp(−extinction · distance)) over what lies behind. Surfaces receive their
 * light undimmed; of the sky, which is infinitely far, nothing is seen.
 */
public record Fog(
        @Written(required = true, min = 0, max = 1e3) double extinctionPerMetre,
        @Written(required = true, min = 0, max = 1e9) Vec3 radiance) {}
