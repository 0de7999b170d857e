// The factor on radiance before the tone curve.
#include "frame.glsl"

#ifdef EXPOSURE_METERED
// One texel, see render.resource.MeteredExposure: of the last picture in its views, of this one afterwards.
uniform sampler2D exposure;

float exposureFactor() {
    return texelFetch(exposure, ivec2(0), 0).x;
}
#else
float exposureFactor() {
    return toneMapping.x;
}
#endif
