#include "shadow-filter.glsl"

uniform samplerBuffer inputs;
layout(location = 0) out vec4 result;

// Per pixel: texel position, half a texel's depth, slope; the receiver's normal and depth; the four depths as gathered.
void main() {
    int at = 3 * int(gl_FragCoord.x);
    vec4 place = texelFetch(inputs, at);
    vec4 receiver = texelFetch(inputs, at + 1);
    vec4 depths = texelFetch(inputs, at + 2);
    Footprint four = footprintAt(place.xy);
    vec4 nearerBy = receiver.w + place.w * (four.dx - four.dy) * 0.5 - depths;
    float share = litShare(nearerBy, four.weight, place.z, place.w);
    float ofMapped = litShareOfMapped(nearerBy, looksLike(depths, receiver.xyz), four.weight, place.z, place.w);
    result = vec4(share, ofMapped, depthWithOctant(depths.x, octantOf(receiver.xyz)) - depths.x, 1.0);
}
