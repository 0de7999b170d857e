#define NEAREST_SHADOW
#include "shadow-filter.glsl"

uniform samplerBuffer inputs;
layout(location = 0) out vec4 result;

// Per pixel: texel position, gradient; the receiver's normal and depth; the four depths as gathered; half a texel's depth
// and the light's range.
void main() {
    int at = 4 * int(gl_FragCoord.x);
    vec4 place = texelFetch(inputs, at);
    vec4 receiver = texelFetch(inputs, at + 1);
    vec4 depths = texelFetch(inputs, at + 2);
    vec4 scale = texelFetch(inputs, at + 3);
    Footprint four = footprintAt(place.xy);
    float slope = abs(place.z) + abs(place.w);
    vec4 nearerBy = nearerThanPlane(depths, receiver.w, place.zw, four);
    vec4 ofLight = nearerThanPlaneOfLight(depths, receiver.w * scale.y, place.zw, scale.y, four);
    float share = litShare(nearerBy, four.weight, scale.x, slope);
    float ofMapped = litShareOfMapped(nearerBy, looksLike(depths, receiver.xyz), four.weight, scale.x, slope);
    bool isLike = looksLike(depths, receiver.xyz).x > 0.0;
    float nearest = 100.0 * litByNearest(nearerBy.x, scale.x, slope)
            + 200.0 * litByNearestOfMapped(nearerBy.x, isLike, scale.x, slope);
    result = vec4(share, ofMapped, dot(ofLight, vec4(1.0, 2.0, 3.0, 4.0)) + nearest, 1.0);
}
