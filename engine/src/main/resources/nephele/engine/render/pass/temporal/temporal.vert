#include "fullscreen.glsl"

out vec2 st; // 0 to 1

void main() {
    vec2 corner = fullScreenCorner();
    st = 0.5 * corner + 0.5;
    gl_Position = vec4(corner, 0.0, 1.0);
}
