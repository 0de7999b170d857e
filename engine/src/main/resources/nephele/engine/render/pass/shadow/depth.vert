#include "shadow-filter.glsl"

layout(location = 0) in vec3 position; // in its cell
layout(location = 1) in vec4 normalAndMaterial;

uniform mat4 clipFromCell;

flat out uint octant;

void main() {
    gl_Position = clipFromCell * vec4(position, 1.0);
    octant = octantOf(normalAndMaterial.xyz);
}
