#include "lamp-depth.glsl"

void main() {
    gl_FragDepth = shadowDepth();
}
