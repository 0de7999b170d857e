#include "exposure.glsl"
#include "fullscreen.glsl"

flat out float factor; // here, not at each pixel: a look-up would cost as much as the rest of the shader

void main() {
    factor = exposureFactor();
    gl_Position = vec4(fullScreenCorner(), 0.0, 1.0);
}
