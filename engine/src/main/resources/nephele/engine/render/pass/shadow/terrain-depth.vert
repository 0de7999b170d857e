#include "terrain-position.glsl"

uniform mat4 clipFromOrigin;

out vec3 fromOrigin;

void main() {
    ivec2 column = terrainSample();
    fromOrigin = terrainRelative(column, terrainHeight(column));
    gl_Position = clipFromOrigin * vec4(fromOrigin, 1.0);
}
