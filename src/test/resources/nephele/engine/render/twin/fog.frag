#include "fog.glsl"

uniform samplerBuffer inputs;
layout(location = 0) out vec4 result;

// Per pixel: radiance, metres; the fog's radiance, extinction per metre.
void main() {
    int at = 2 * int(gl_FragCoord.x);
    vec4 behind = texelFetch(inputs, at);
    result = vec4(behindFog(behind.rgb, texelFetch(inputs, at + 1), behind.a), 1.0);
}
