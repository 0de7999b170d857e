package nephele.engine.level;

import nephele.engine.math.Vec3;

/**
 * Homogeneous fog of unlimited extent: it adds radiance · (1 − exp(−extinction · distance)) and attenuates what is
 * behind. It does not attenuate the light that surfaces receive. It hides the sky, which is at infinite distance.
 */
public record Fog(
        @Written(required = true, min = 0, max = 1e3) double extinctionPerMetre,
        @Written(required = true, min = 0, max = 1e9) Vec3 radiance) {}
