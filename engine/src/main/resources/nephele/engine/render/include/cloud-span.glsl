// The part of a ray in the bounds of a cloud. Twin: nephele.engine.cloud.cells.StackSpan.
const float NEVER = 1e30;

// The greater root of a t² + b t + c for c ≤ 0: where a ray rises through a height.
float later(float a, float b, float c) {
    float root = sqrt(max(0.0, b * b - 4.0 * a * c));
    float q = b + (b < 0.0 ? -root : root);
    float t = b < 0.0 ? (a > 0.0 ? -q / (2.0 * a) : NEVER) : q > 0.0 ? -2.0 * c / q : NEVER;
    return max(0.0, t);
}

// The smaller positive root for c ≥ 0: where a ray falls through a height.
float sooner(float a, float b, float c) {
    float square = b * b - 4.0 * a * c;
    return b < 0.0 && square >= 0.0 ? 2.0 * c / (-b + sqrt(square)) : NEVER;
}

// The first part of a ray between two heights: the coefficients of the quadratic equations.
vec2 betweenHeights(float bend, float slope, float overBase, float overTop) {
    if (overBase < 0.0) {
        return vec2(later(bend, slope, overBase), later(bend, slope, overTop));
    }
    float down = sooner(bend, slope, overBase);
    float enter = overTop <= 0.0 ? 0.0 : sooner(bend, slope, overTop);
    // Above the top the greater root is where the ray leaves it again.
    float leave = overTop <= 0.0 ? later(bend, slope, overTop)
        : bend > 0.0 ? (-slope + sqrt(max(0.0, slope * slope - 4.0 * bend * overTop))) / (2.0 * bend) : NEVER;
    return enter == NEVER ? vec2(NEVER, 0.0) : vec2(enter, min(down, leave));
}

// planet: x: 1 / twice the radius around which a layer bends, 0 for none; y: height of the eye, metres
float spanSlope(vec3 ray, vec2 planet) {
    return ray.y * (1.0 + 2.0 * planet.x * planet.y);
}

// The constant for a height that is so much above the eye's.
float spanOver(float above, vec2 planet) {
    return -above * (1.0 + planet.x * (2.0 * planet.y + above));
}

// How much higher than the eye a ray is after a distance.
float heightAbove(vec3 ray, float metres, vec2 planet) {
    float above = metres * (spanSlope(ray, planet) + planet.x * metres);
    return above / (1.0 + planet.x * (2.0 * planet.y + above));
}

// The distance at which the planet hides the rest of a ray.
float planetMetres(vec3 ray, vec2 planet) {
    return planet.x > 0.0 && planet.y >= 0.0
        ? sooner(planet.x, spanSlope(ray, planet), spanOver(-planet.y, planet)) : NEVER;
}

// base: middle of the lower side; extent: half of the sides x and z, and the height y
vec2 spanInside(vec3 ray, vec3 base, vec3 extent, vec2 planet) {
    vec2 inside = betweenHeights(
        planet.x, spanSlope(ray, planet), spanOver(base.y, planet), spanOver(base.y + extent.y, planet));
    vec2 a = (base.xz - extent.xz) / ray.xz;
    vec2 b = (base.xz + extent.xz) / ray.xz;
    vec2 near = min(a, b);
    vec2 far = max(a, b);
    return vec2(max(inside.x, max(near.x, near.y)), min(inside.y, min(far.x, far.y)));
}
