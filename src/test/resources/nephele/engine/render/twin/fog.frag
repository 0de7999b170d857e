uniform samplerBuffer inputs;
layout(location = 0) out vec4 result;

vec4 fog;
vec4 fogPlace;
#define FOG_LAYER
#include "fog.glsl"

// Per pixel: the place from the eye, x and y; extinction per metre, the eye's scaled altitude; 1 / scale height.
void main() {
    int at = 2 * int(gl_FragCoord.x);
    vec4 given = texelFetch(inputs, at);
    fog = vec4(0.0, 0.0, 0.0, given.z);
    fogPlace = vec4(given.w, texelFetch(inputs, at + 1).x, 0.0, 0.0);
    vec3 relative = vec3(given.xy, 0.0);
    result = vec4(throughFog(relative), skyThroughFog(relative), behindFog(vec3(1.0), relative).x, 1.0);
}
