// For surfaces that glow the same in every light: radiance whose tone-mapped value is about these linear display
// values.
#include "frame.glsl"

vec3 radianceOf(vec3 displayed) {
#ifdef OUTPUT_PLAIN
    return displayed;
#else
    return displayed / max(toneMapping.x, 1e-6);
#endif
}
