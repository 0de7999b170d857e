// The share of the sun's light that clouds leave.
#include "light.glsl"

uniform sampler3D cloudShade;

float cloudLitShare(vec3 anchorPosition) {
    return textureLod(cloudShade, (anchorPosition - cloudShadeMin) * cloudShadePerMetre, 0.0).r;
}
