// Light that a part of a ray through a cloud sends to the eye, from the cloud's cells of light. STEADY: there is no next time.
#include "cell-boxes.glsl"

uniform sampler3D cloudDensity; // r, a: density at the last and the next sampled time; g: distance to the nearest cell with
                                // some; b: light that absorption leaves
uniform sampler3D cloudLight; // at the last time: sun-ward depth, diffuse mean, diffuse slope, share from above
#ifndef STEADY
uniform sampler3D cloudLightToCome; // at the next time
#endif
uniform sampler2D smallAngles; // by separation and depth
uniform vec4 medium; // greatest extinction per metre; scaled divided by true depth; albedo; scaled albedo
uniform vec4 phase; // scaled cosine; 1 / deepest depth of smallAngles; 1 / twice the planet's radius, 0 if flat; asymmetry
uniform vec3 cloudSun; // towards the sun
uniform vec4 diffuseAxis; // xyz: along which diffuse light flows besides along the beam; w: its slope along the beam per
                          // unit irradiance of the beam

const float FOUR_PI = 12.5663706;
const float BRIGHTEST = java(cloud.light.CloudLight.BRIGHTEST); // mean diffuse radiance deep under a side that is lit at a right angle
const float OBLIQUITY = java(cloud.light.CloudLight.OBLIQUITY); // distance from a side along its normal, divided by that along a ray, on the mean
const float OPAQUE = java(cloud.cells.CellMarch.OPAQUE);
const float SEPARATIONS = java(cloud.light.SmallAngleScattering.SEPARATIONS);
const float DEPTHS = java(cloud.light.SmallAngleScattering.DEPTHS);

struct CloudRay {
    float transmittance;
    float sunlight; // per irradiance
    float above; // share of the upper sky's mean radiance
    float below;
    float metres; // of the part that is seen
    float scaled; // transmittance of the medium whose forward peak passes
    float eyeDepth; // optical depth up to here
    float exitLight; // share of the beam where the ray meets the cloud
    float lastDiffuse;
};

// What the light of all parts of a ray has in common.
struct RayAngles {
    float cosine; // between the ray and the direction towards the sun
    float separation; // 2 - 2 cosine
    float column; // of the separation in smallAngles
    float once; // phase function of the scaled medium
    float axisCosine;
    float resistance; // to diffuse light, per optical depth
    float depthAround; // optical depth around the place where the view begins
};

vec4 lightOf(vec3 place, float height, float box) {
    vec3 texel = texelOf(place, height, box, cells.y);
    vec4 light = textureLod(cloudLight, texel, 0.0);
#ifndef STEADY
    light = cells.w > 0.0 ? mix(light, textureLod(cloudLightToCome, texel, 0.0), cells.w) : light;
#endif
    return light;
}

vec4 lightAt(vec3 place, float height) {
    vec2 box = boxOf(place);
    vec4 light = vec4(0.0);
    float share = 1.0;
    // A loop, since a software renderer runs both sides of a condition.
    do {
        light = mix(light, lightOf(place, height, box.x), share);
        share = box.y;
        box = vec2(box.x + 1.0, 0.0);
    } while (share > 0.0);
    return light;
}

// Light that turns once by any angle or often by small ones, per optical depth.
// column: of the separation in smallAngles
float smallAngleLight(float column, float depth) {
    float row = sqrt(min(1.0, depth * phase.y)) * ((DEPTHS - 1.0) / DEPTHS) + 0.5 / DEPTHS;
    return textureLod(smallAngles, vec2(column, row), 0.0).r;
}

#if defined(OCTAVES) || defined(BEAM)
float henyeyGreenstein(float g, float separation) {
    float squared = (1.0 - g) * (1.0 - g) + g * separation;
    return (1.0 - g) * (1.0 + g) / (FOUR_PI * squared * sqrt(squared));
}
#endif

#ifdef OCTAVES
// Light scattered towards the eye per optical depth, by octaves of single scattering (Wrenninge 2013; the form of
// Hillaire 2016, "Physically Based Sky, Atmosphere and Cloud Rendering in Frostbite", equations 19 and 20).
float octaves(float separation, float sunDepth) {
    float light = 0.0;
    float share = 1.0;
    for (int n = 0; n < 8; n++) {
        light += share * henyeyGreenstein(phase.w * share, separation) * exp(-share * sunDepth);
        share *= 0.5;
    }
    return light;
}
#endif

// The share of light that an optical depth takes; the difference would lose the digits of a small one.
float takenBy(float depth) {
    return depth < 1e-2 ? depth * (1.0 - depth * (0.5 - depth / 6.0)) : 1.0 - exp(-depth);
}

// Mean optical depth at which light that a step takes is taken.
float meanDepth(float depth) {
    float left = exp(-depth);
    return depth < 1e-2 ? depth * (0.5 - depth / 12.0) : 1.0 - depth * left / (1.0 - left);
}

// direction: of unit length
RayAngles rayAngles(vec3 direction, float depthAround) {
    vec3 apart = direction - cloudSun;
    float separation = dot(apart, apart);
    float cosine = 1.0 - 0.5 * separation;
    float column = sqrt(sqrt(0.25 * separation)) * ((SEPARATIONS - 1.0) / SEPARATIONS) + 0.5 / SEPARATIONS;
    float once = (1.0 + 3.0 * phase.x * cosine) / FOUR_PI;
    float axisCosine = -dot(direction, diffuseAxis.xyz);
    float resistance = 0.75 * (1.0 - phase.x) * medium.y;
    return RayAngles(cosine, separation, column, once, axisCosine, resistance, depthAround);
}

CloudRay emptyRay() {
    return CloudRay(1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0);
}

// Adds a part of a ray behind those before it.
// depth: its optical depth; mean: meanDepth(depth); light: of the cells, where its light is taken; left: what absorption
// leaves of light from all around; metres: where it is seen
void addPart(inout CloudRay ray, RayAngles angles, float depth, float mean, vec4 light, float left, float metres) {
    float taken = takenBy(depth);
    float scaledTaken = takenBy(medium.y * depth);
#ifdef OCTAVES
    ray.sunlight += ray.transmittance * taken * medium.z * octaves(angles.separation, light.r);
#else
    float narrow = smallAngleLight(angles.column, light.r + ray.eyeDepth + mean) * taken * exp(mean);
    float beam = exp(-medium.y * light.r);
    // Between the sides towards the sun and towards the eye the light is no brighter than in a slab between them.
    ray.exitLight = ray.transmittance == 1.0 ? beam : ray.exitLight;
    float toSun = 1.0 + angles.resistance * OBLIQUITY * light.r;
    float toEye = 1.0 + angles.resistance * (angles.depthAround + ray.eyeDepth + mean);
    float kept = min(1.0, BRIGHTEST * (toEye + ray.exitLight * toSun) / ((toEye + toSun) * max(light.g, 1e-10)));
    float slope = angles.cosine * clamp(diffuseAxis.w * beam, -light.g, light.g) + angles.axisCosine * light.b;
    ray.lastDiffuse = medium.w * (angles.once * beam + kept * max(0.0, light.g + phase.x * slope));
    ray.eyeDepth += depth;
    ray.sunlight += narrow + ray.scaled * scaledTaken * ray.lastDiffuse;
#endif
    float seen = ray.transmittance * taken;
    ray.above += seen * medium.z * light.a;
    ray.below += seen * medium.z * (left - light.a);
    ray.metres += seen * metres;
    ray.transmittance -= seen;
    ray.scaled *= 1.0 - scaledTaken;
}

// Ends a ray; one that is nearly opaque becomes opaque.
void endRay(inout CloudRay ray) {
    float covered = 1.0 - ray.transmittance;
    ray.metres /= max(covered, 1e-6);
    if (ray.scaled <= OPAQUE) {
        // What is behind is taken as the last step, so that the early end loses no light.
        ray.sunlight += ray.scaled * ray.lastDiffuse;
        ray.above /= covered;
        ray.below /= covered;
        ray.transmittance = 0.0;
    }
    ray.sunlight = max(0.0, ray.sunlight);
}
