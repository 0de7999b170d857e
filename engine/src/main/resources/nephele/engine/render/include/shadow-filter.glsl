// Share of a 2 x 2 texel footprint that sees the light, bilinearly weighted. The receiver is taken as a plane and its
// depth evaluated at each texel's own centre, so a lit plane never shades itself, however it slopes, and no offset moves
// the shadow's edge. Twin: nephele.engine.scene.light.ShadowFilter.

// The four texels around a position, in the order in which textureGather returns them.
struct Footprint {
    vec4 dx; // from the position to their centres, texels
    vec4 dy;
    vec4 weight;
};

Footprint footprintAt(vec2 texelPosition) {
    vec2 f = texelPosition - 0.5 - floor(texelPosition - 0.5);
    vec4 dx = vec4(-f.x, 1.0 - f.x, 1.0 - f.x, -f.x);
    vec4 dy = vec4(1.0 - f.y, 1.0 - f.y, -f.y, -f.y);
    return Footprint(dx, dy, (1.0 - abs(dx)) * (1.0 - abs(dy)));
}

// Where textureGather reads the four texels around a position without doubt about rounding.
vec2 gatherPoint(vec2 texelPosition) {
    return floor(texelPosition - 0.5) + 1.0;
}

// Depth by which each texel is nearer to the light than a plane; beyond all depth nothing is farther. gradient: change of
// the plane's depth from texel to texel.
vec4 nearerThanPlane(vec4 depths, float planeDepth, vec2 gradient, Footprint four) {
    return min(planeDepth + gradient.x * four.dx + gradient.y * four.dy, 1.0) - depths;
}

// The same where depth is distance over range: over the picture of a plane 1 / distance is linear. gradient: change of
// that from texel to texel.
vec4 nearerThanPlaneOfLight(vec4 depths, float distance, vec2 gradient, float range, Footprint four) {
    vec4 perDistance = 1.0 / distance + gradient.x * four.dx + gradient.y * four.dy;
    return 1.0 / max(perDistance * range, 1.0) - depths;
}

// nearerBy: depth by which each texel is nearer to the light than the receiver's plane; slope: change of that plane's
// depth from texel to texel. A face that rises from another one reads texels of that other one at their joint: what lies
// half a texel nearer does not shade, and up to two more with the receiver's slope.
float litShare(vec4 nearerBy, vec4 weight, float halfTexelDepth, float slope) {
    return dot(weight, step(nearerBy, vec4(halfTexelDepth + min(slope, 4.0 * halfTexelDepth))));
}

// Which way a face looks, in three bits; the six faces of an upright box differ. The pictures of what never moves hold it
// in the last bits of their depth. No plain slope lies on a border, where rounding would decide.
uint octantOf(vec3 normal) {
    vec3 sides = normal * mat3(0.8971, 0.8113, 0.7019, 0.7907, -0.9043, 0.6133, 0.6803, 0.5941, -0.9187);
    return (sides.x > 0.0 ? 1u : 0u) | (sides.y > 0.0 ? 2u : 0u) | (sides.z > 0.0 ? 4u : 0u);
}

float depthWithOctant(float depth, uint octant) {
    return uintBitsToFloat((floatBitsToUint(depth) & ~7u) | octant);
}

// 1 for texels that may show the receiver: they look its way, or beyond all depth.
vec4 looksLike(vec4 depths, vec3 faceNormal) {
    return max(vec4(equal(floatBitsToUint(depths) & 7u, uvec4(octantOf(faceNormal)))), step(1.0, depths));
}

// As litShare, for a receiver that is in the map itself, which then shows it in some of the four texels: only those that
// show its plane and those that shade it count. What lies behind the plane is seen past an edge that is closer than a
// texel, and no proof of light; what is before it, but not by much, is a face at a joint, and no proof of shade.
float litShareOfMapped(vec4 nearerBy, vec4 isLike, vec4 weight, float halfTexelDepth, float slope) {
    float rounding = 0.125 * halfTexelDepth + min(slope / 64.0, 2.0 * halfTexelDepth);
    vec4 nearer = step(rounding, nearerBy);
    float lit = dot(weight * isLike, step(-rounding, nearerBy) - nearer);
    float shaded = dot(weight, step(5.0 * halfTexelDepth + 2.0 * slope, nearerBy));
    float before = dot(weight, nearer);
    if (lit > 0.0) {
        // The last corner of a lit texel does not outweigh what stands close before all the rest.
        return lit / (lit + shaded + max(0.15 - lit, 0.0) * (before - shaded));
    }
    return before > 0.0 ? 0.0 : 1.0;
}
