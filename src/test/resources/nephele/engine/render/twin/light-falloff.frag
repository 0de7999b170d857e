#include "light-falloff.glsl"

uniform samplerBuffer inputs;
layout(location = 0) out vec4 result;

// Per pixel: square distance, 1 / range^2; cosine, scale, offset.
void main() {
    int at = 2 * int(gl_FragCoord.x);
    vec4 distances = texelFetch(inputs, at);
    vec4 cone = texelFetch(inputs, at + 1);
    result = vec4(windowedInverseSquare(distances.x, distances.y), coneFactor(cone.x, cone.y, cone.z), 0.0, 1.0);
}
