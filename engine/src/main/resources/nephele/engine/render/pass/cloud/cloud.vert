#include "frame.glsl"
#include "fullscreen.glsl"

out vec3 direction; // not of unit length; its part along the view's axis is 1

void main() {
    vec2 corner = fullScreenCorner();
    direction = shownDirection(corner);
#ifdef FARTHEST
    gl_Position = vec4(corner, 1.0, 1.0);
#else
    gl_Position = vec4(corner, 0.0, 1.0);
#endif
}
