#include "shadow-filter.glsl"

uniform sampler2DArray sprites;

in vec2 st;
flat in float layer;
flat in uint octant;

void main() {
    if (texture(sprites, vec3(st, layer)).a < 0.5) {
        discard;
    }
    gl_FragDepth = depthWithOctant(gl_FragCoord.z, octant);
}
