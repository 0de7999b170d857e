#include "output.glsl"

uniform sampler2DArray faces;

in vec3 direction; // not of unit length
in vec2 st;
flat in float face;

void main() {
    vec3 radiance = texture(faces, vec3(st, face)).rgb;
#ifdef WHITE_RADIANCE
    radiance *= float(WHITE_RADIANCE);
#endif
    writeSky(radiance, direction);
}
