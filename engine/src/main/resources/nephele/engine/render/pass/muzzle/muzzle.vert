#include "fullscreen.glsl"

void main() {
    gl_Position = vec4(fullScreenCorner(), 1.0, 1.0);
}
