#include "cloud-octaves.glsl"

uniform samplerBuffer inputs;
layout(location = 0) out vec4 result;

// Per pixel: place x and z.
void main() {
    vec4 place = texelFetch(inputs, int(gl_FragCoord.x));
    result = vec4(columnOfOctaves(place.xy, 0.0), columnOfOctaves(place.xy, place.z), octaveAt(0, place.xy), 1.0);
}
