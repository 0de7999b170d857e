#include "light-depth.glsl"

void main() {
    gl_FragDepth = shadowDepth();
}
