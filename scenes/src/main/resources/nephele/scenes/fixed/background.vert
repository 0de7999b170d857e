#include "fullscreen.glsl"

out vec2 texturePoint;

void main() {
    vec2 corner = fullScreenCorner();
    texturePoint = 0.5 * corner + 0.5;
    gl_Position = vec4(corner, 0.0, 1.0);
}
