// For surfaces that glow the same in every light: radiance whose tone-mapped value is about these linear display
// values.
#include "exposure.glsl"

vec3 radianceOf(vec3 displayed) {
#ifdef OUTPUT_PLAIN
    return displayed;
#else
    return displayed / max(exposureFactor(), 1e-6);
#endif
}
