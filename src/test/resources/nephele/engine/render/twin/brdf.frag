#include "brdf.glsl"

uniform samplerBuffer inputs;
layout(location = 0) out vec4 result;

// Per pixel: colour and roughness; normal and metallic; to the eye; to the light.
void main() {
    int at = 4 * int(gl_FragCoord.x);
    vec4 colour = texelFetch(inputs, at);
    vec4 normal = texelFetch(inputs, at + 1);
    vec3 toEye = texelFetch(inputs, at + 2).xyz;
    vec3 toLight = texelFetch(inputs, at + 3).xyz;
    Brdf b = brdfOf(colour.rgb, colour.a, normal.w, dot(normal.xyz, toEye));
    result = vec4(reflectedLight(b, normal.xyz, toEye, toLight), 1.0);
}
