#include "shadow-filter.glsl"
#include "light-depth.glsl"

in vec3 fromOrigin;

void main() {
    vec3 n = cross(dFdx(fromOrigin), dFdy(fromOrigin));
    gl_FragDepth = depthWithOctant(shadowDepth(), octantOf(n.y < 0.0 ? -n : n));
}
