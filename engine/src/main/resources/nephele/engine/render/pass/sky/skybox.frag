#include "output.glsl"

uniform sampler2DArray faces;
uniform float whiteRadiance;

in vec3 direction; // not of unit length
in vec2 st;
flat in float face;

void main() {
    writeSky(whiteRadiance * texture(faces, vec3(st, face)).rgb, direction);
}
