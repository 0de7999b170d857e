#include "shot-look.glsl"
#include "gun-light.glsl"

uniform samplerBuffer inputs;
layout(location = 0) out vec4 result;

// Per pixel: along, across, age; then a place and a normal. The opacity of a bolt; the light of lamps and flash.
void main() {
    int at = 2 * int(gl_FragCoord.x);
    vec3 shot = texelFetch(inputs, at).xyz;
    vec3 p = vec3(texelFetch(inputs, at).w, texelFetch(inputs, at + 1).xy);
    float angle = texelFetch(inputs, at + 1).z;
    vec3 n = vec3(cos(angle), 0.6 * sin(angle), 0.8 * sin(angle));
    vec2 light = gunLight(p, n);
    result = vec4(boltOpacity(shot.x, shot.y, shot.z) + 2.0 * shimmerOpacity(abs(shot.y), shot.z), light, 1.0);
}
