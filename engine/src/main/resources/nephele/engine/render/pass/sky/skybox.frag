#include "output.glsl"

uniform sampler2DArray faces;

in vec2 st;
flat in float face;

void main() {
    writeRadiance(texture(faces, vec3(st, face)).rgb);
}
