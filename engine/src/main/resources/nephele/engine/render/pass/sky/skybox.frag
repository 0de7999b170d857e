#include "output.glsl"

uniform sampler2DArray faces;
uniform float whiteRadiance;

in vec2 st;
flat in float face;

void main() {
    writeRadiance(whiteRadiance * texture(faces, vec3(st, face)).rgb);
}
