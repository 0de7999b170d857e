#define LIGHT_DIRECTIONS
#define NORMAL_MAP
#include "baked-light.glsl"

uniform samplerBuffer inputs;
layout(location = 0) out vec4 result;

// Per pixel: mean direction, then normal.
void main() {
    int at = 2 * int(gl_FragCoord.x);
    vec3 d = texelFetch(inputs, at).xyz;
    result = vec4(relativeIrradiance(d, texelFetch(inputs, at + 1).xyz), length(d), 0.0, 1.0);
}
