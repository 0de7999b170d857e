#include "shadow-filter.glsl"
#include "lamp-depth.glsl"

flat in uint octant;

void main() {
    gl_FragDepth = depthWithOctant(shadowDepth(), octant);
}
