#include "frame.glsl"
#include "fullscreen.glsl"

out vec3 direction; // not of unit length

void main() {
    vec2 corner = fullScreenCorner();
    direction = shownDirection(corner);
    gl_Position = vec4(corner, 1.0, 1.0);
}
