#include "fullscreen.glsl"

void main() {
    // In front of the mark of copy.frag, behind everything else.
    gl_Position = vec4(fullScreenCorner(), -0.5, 1.0);
}
