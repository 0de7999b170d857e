// The light of soft balls that a cloud is divided into, from the cells of the cloud.
#include "cloud-march.glsl"
#include "puff.glsl"

uniform vec3 irradiance; // of the sun at the cloud
uniform vec3 skyAbove; // mean radiance of the upper half of the sky
uniform vec3 skyBelow;

const int SIGHT_STEPS = 24;

// Optical depths of the cloud on a ray before and behind a part of it.
vec2 depthsBeside(vec3 ray, vec2 span) {
    vec2 inside = insideCloud(ray);
    inside.x = max(0.0, inside.x);
    float stepMetres = (inside.y - inside.x) / float(SIGHT_STEPS);
    vec2 sums = vec2(0.0);
    for (int n = 0; n < SIGHT_STEPS && stepMetres > 0.0; n++) {
        float at = inside.x + (float(n) + 0.5) * stepMetres;
        vec3 place = at * ray;
        vec4 cell = textureLod(cloudDensity, texelOf(place, place.y, 0.0, cells.x), 0.0);
        float depth = cellDensity(cell) * medium.x * stepMetres;
        sums += depth * vec2(at < span.x ? 1.0 : 0.0, at > span.y ? 1.0 : 0.0);
    }
    return sums;
}

// Light that a ball at a place sends per optical depth.
struct PuffLight {
    float narrow; // sunlight that keeps near its direction, per unit irradiance
    float straight; // optical depth of the ray on which that light can lie
    float diffuse; // other sunlight, if the ball is opaque
    vec3 sky; // light of the sky, if the ball is opaque
};

// How fast the light that keeps near its direction fades along a ray: towards the sun, depths from it and to the eye add up to
// the same everywhere; in other directions they grow.
float narrowFading(vec3 ray) {
    vec3 apart = ray - cloudSun;
    return max(1e-3, medium.y * 0.5 * dot(apart, apart));
}

// Light of the sky, if the ball is opaque. fromAbove: its share that comes from the upper half
vec3 puffSky(vec3 place, float fromAbove) {
    float left = textureLod(cloudDensity, texelOf(place, place.y, 0.0, cells.x), 0.0).b;
    return medium.z * (fromAbove * skyAbove + max(0.0, left - fromAbove) * skyBelow);
}

PuffLight puffLight(vec3 place, vec3 ray, float toEye) {
    vec4 light = lightAt(place, place.y);
    RayAngles angles = rayAngles(ray, stepping.w);
    float beam = exp(-medium.y * light.r);
    float toSun = 1.0 + angles.resistance * OBLIQUITY * light.r;
    float toOutside = 1.0 + angles.resistance * (angles.depthAround + toEye);
    float kept = min(1.0, BRIGHTEST * (toOutside + beam * toSun) / ((toOutside + toSun) * max(light.g, 1e-10)));
    float slope = angles.cosine * clamp(diffuseAxis.w * beam, -light.g, light.g) + angles.axisCosine * light.b;
    return PuffLight(
        smallAngleLight(angles.column, light.r + toEye),
        2.0 * (light.r + toEye + 1.0),
        medium.w * (angles.once * beam + kept * max(0.0, light.g + phase.x * slope)),
        puffSky(place, light.a));
}
