#include "relative-position.glsl"

void main() {
    placeVertex();
}
