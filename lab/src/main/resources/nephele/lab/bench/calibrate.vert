#include "fullscreen.glsl"

out vec2 across;

void main() {
    vec2 corner = fullScreenCorner();
    across = corner * 0.5 + 0.5;
    gl_Position = vec4(corner, 0.0, 1.0);
}
