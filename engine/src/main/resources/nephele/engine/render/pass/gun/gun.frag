// The gun's radiance, computed at its vertices.
#include "output.glsl"

in vec3 radiance;

void main() {
    writeRadiance(radiance);
#ifdef EXPOSURE_METERED
    pixel.a = 0.0; // the hand before the eye is no part of the metered picture
#endif
}
