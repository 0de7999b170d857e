// How far all clouds are along a ray: the parts of it in each cloud's bounds, joined.
uniform vec3 rangeBase[CLOUDS]; // middle of the lower side, relative to the eye
uniform vec3 rangeHalf[CLOUDS]; // x, z: half of the widest sides; y: height
uniform vec2 rangePlanet; // of spanInside

#include "cloud-span.glsl"

// Nearest and farthest distance; empty if the first is the greater one.
vec2 rangeOfClouds(vec3 ray) {
    vec2 range = vec2(NEVER, 0.0);
    for (int i = 0; i < CLOUDS; i++) {
        vec2 inside = spanInside(ray, rangeBase[i], rangeHalf[i], rangePlanet);
        if (inside.x < inside.y) {
            range = vec2(min(range.x, inside.x), max(range.y, inside.y));
        }
    }
    return range;
}
