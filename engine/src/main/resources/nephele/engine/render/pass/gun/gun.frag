// The gun's radiance, computed at its vertices.
#include "output.glsl"

const float IN_HAND = java(render.pass.temporal.TemporalPass.IN_HAND);

in vec3 radiance;

void main() {
    writeRadiance(radiance);
#ifdef DISTANCE_STORED
    pixel.a = IN_HAND;
#endif
#ifdef EXPOSURE_METERED
    pixel.a = 0.0; // the hand before the eye is no part of the metered picture
#endif
}
