#include "shadow-filter.glsl"

uniform samplerBuffer inputs;
layout(location = 0) out vec4 result;

// Per pixel: texel position, receiver depth; gradient and half a texel's depth; the four depths as gathered.
void main() {
    int at = 3 * int(gl_FragCoord.x);
    vec4 place = texelFetch(inputs, at);
    vec4 slope = texelFetch(inputs, at + 1);
    float tolerance = contactTolerance(slope.z, slope.xy);
    float share = litShare(texelFetch(inputs, at + 2), place.xy, place.z - tolerance, slope.xy);
    result = vec4(share, tolerance, 0.0, 1.0);
}
