#include "frame.glsl"

layout(location = 0) in vec3 corner; // on the cube around the eye
layout(location = 1) in vec3 texel; // s, t, face

out vec3 direction;
out vec2 st;
flat out float face;

void main() {
    direction = corner;
    st = texel.xy;
    face = texel.z;
    // Puts the vertex on the far plane, with w as depth.
    gl_Position = (clipFromRelative * vec4(corner, 0.0)).xyww;
}
