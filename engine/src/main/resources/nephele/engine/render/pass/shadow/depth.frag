#include "shadow-filter.glsl"
#include "light-depth.glsl"

flat in uint octant;

void main() {
    gl_FragDepth = depthWithOctant(shadowDepth(), octant);
}
