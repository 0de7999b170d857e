// The share of a 2 x 2 texel footprint that receives light, bilinearly weighted. The receiver's plane is evaluated at
// each texel's own centre, so a lit plane of any slope never shades itself, and no offset moves the shadow's edge.
// Twin: nephele.engine.scene.light.ShadowFilter in src/test/java.

// Exceeds the depth of every receiver, in depths of a map.
const float FARTHEST = 1e9;

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

// Returns the point where textureGather reads the four texels around a position independent of rounding.
vec2 gatherPoint(vec2 texelPosition) {
    return floor(texelPosition - 0.5) + 1.0;
}

// Returns the depth by which each texel is nearer to the light than a plane; an empty one, of the far value of depth, is
// never nearer. gradient: change of the plane's depth from texel to texel.
vec4 nearerThanPlane(vec4 depths, float planeDepth, vec2 gradient, Footprint four) {
    vec4 nearerBy = planeDepth + gradient.x * four.dx + gradient.y * four.dy - depths;
    return min(nearerBy, FARTHEST - FARTHEST * step(1.0, depths));
}

// Returns the same for depth that is distance over range: over the picture of a plane, 1 / distance is linear.
// gradient: its change from texel to texel.
vec4 nearerThanPlaneOfLight(vec4 depths, float distance, vec2 gradient, float range, Footprint four) {
    vec4 perDistance = 1.0 / distance + gradient.x * four.dx + gradient.y * four.dy;
    return 1.0 / max(perDistance * range, 1.0) - depths;
}

// nearerBy: depth by which each texel is nearer to the light than the receiver's plane; slope: change of that plane's
// depth from texel to texel. A face that rises from another one reads texels of that one at their joint: a texel nearer
// by less than half a texel casts no shadow, and by up to two more with the receiver's slope.
float litShare(vec4 nearerBy, vec4 weight, float halfTexelDepth, float slope) {
    return dot(weight, step(nearerBy, vec4(halfTexelDepth + min(slope, 4.0 * halfTexelDepth))));
}

// Returns the octant of a face's normal, in three bits; the six faces of an upright box differ. The pictures of static
// geometry hold it in the last bits of their depth. No common slope is on a border, where rounding would decide.
uint octantOf(vec3 normal) {
    vec3 sides = normal * mat3(0.8971, 0.8113, 0.7019, 0.7907, -0.9043, 0.6133, 0.6803, 0.5941, -0.9187);
    return (sides.x > 0.0 ? 1u : 0u) | (sides.y > 0.0 ? 2u : 0u) | (sides.z > 0.0 ? 4u : 0u);
}

float depthWithOctant(float depth, uint octant) {
    return uintBitsToFloat((floatBitsToUint(depth) & ~7u) | octant);
}

// Returns 1 for texels that may show the receiver: they face the same octant, or are beyond all depth.
vec4 looksLike(vec4 depths, vec3 faceNormal) {
    return max(vec4(equal(floatBitsToUint(depths) & 7u, uvec4(octantOf(faceNormal)))), step(1.0, depths));
}

// As litShare, for a receiver that is in the map itself, which then shows it in some of the four texels: only texels
// that show its plane and texels that shade it count. A texel behind the plane is seen past an edge closer than a texel
// and proves no light; one slightly in front of it is a face at a joint and proves no shadow.
float litShareOfMapped(vec4 nearerBy, vec4 isLike, vec4 weight, float halfTexelDepth, float slope) {
    float rounding = 0.125 * halfTexelDepth + min(slope / 64.0, 2.0 * halfTexelDepth);
    vec4 nearer = step(rounding, nearerBy);
    float lit = dot(weight * isLike, step(-rounding, nearerBy) - nearer);
    float shaded = dot(weight, step(5.0 * halfTexelDepth + 2.0 * slope, nearerBy));
    float before = dot(weight, nearer);
    if (lit > 0.0) {
        // The last corner of a lit texel must not outweigh occluders in front of the other three.
        return lit / (lit + shaded + max(0.15 - lit, 0.0) * (before - shaded));
    }
    return before > 0.0 ? 0.0 : 1.0;
}

#ifdef NEAREST_SHADOW
// Returns the column and row of the texel that contains a position, within the picture.
ivec2 nearestTexel(vec2 texelPosition, vec2 size) {
    return ivec2(clamp(texelPosition, vec2(0.0), size - 1.0));
}

// As nearerThanPlane, of one texel. planeDepth: at its centre
float nearestNearerThanPlane(float depth, float planeDepth) {
    return min(planeDepth - depth, FARTHEST - FARTHEST * step(1.0, depth));
}

// As litShare, of one texel.
float litByNearest(float nearerBy, float halfTexelDepth, float slope) {
    return nearerBy <= halfTexelDepth + min(slope, 4.0 * halfTexelDepth) ? 1.0 : 0.0;
}

// As litShareOfMapped, of one texel: one that shows another face shades only if that face cannot be at a joint.
float litByNearestOfMapped(float nearerBy, bool isLike, float halfTexelDepth, float slope) {
    float rounding = 0.125 * halfTexelDepth + min(slope / 64.0, 2.0 * halfTexelDepth);
    return nearerBy < (isLike ? rounding : 5.0 * halfTexelDepth + 2.0 * slope) ? 1.0 : 0.0;
}
#endif
