#include "dynamic-position.glsl"

uniform mat4 clipFromAnchor;

void main() {
    DynamicVertex v = dynamicVertex();
    gl_Position = clipFromAnchor * vec4(v.centreHigh + v.fromCentre, 1.0);
#ifdef PORTALS
    gl_ClipDistance[0] = 1.0;
#endif
    clipToOwnPlanes(v, vec3(0.0), 0.0);
}
