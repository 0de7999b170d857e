#include "normal-map.glsl"

uniform samplerBuffer inputs;
layout(location = 0) out vec4 result;

// Per pixel: texel; face normal; across; up.
void main() {
    int at = 4 * int(gl_FragCoord.x);
    result = vec4(mappedNormal(texelFetch(inputs, at).rgb, texelFetch(inputs, at + 1).xyz,
            texelFetch(inputs, at + 2).xyz, texelFetch(inputs, at + 3).xyz), 1.0);
}
