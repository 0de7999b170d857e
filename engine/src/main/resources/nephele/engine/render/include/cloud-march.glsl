// Marches a ray through the cells of a cloud. Twin: nephele.engine.cloud.cells.CellMarch.
#include "cloud-span.glsl"
#include "cell-boxes.glsl"

uniform sampler3D cloudDensity; // r, a: density at the last and the next sampled time; g: distance to the nearest cell with
                                // some; b: light that absorption leaves
uniform sampler3D cloudLight; // at the last time: sun-ward depth, diffuse mean, diffuse slope, share from above
uniform sampler3D cloudLightToCome; // at the next time
uniform sampler2D smallAngles; // by separation and depth
uniform vec4 cellEdges; // xyz: edges of a cell of the narrowest box; w: the shortest
uniform vec4 medium; // greatest extinction per metre; scaled divided by true depth; albedo; scaled albedo
uniform vec4 phase; // scaled cosine; 1 / deepest depth of smallAngles; 1 / twice the planet's radius, 0 if flat; asymmetry
uniform vec3 cloudSun; // towards the sun
uniform vec4 diffuseAxis; // xyz: along which diffuse light flows besides along the beam; w: its slope along the beam per
                          // unit irradiance of the beam
uniform vec4 stepping; // cells of a step; place of the first sample in its step; the eye's height over a round planet; optical
                       // depth around the place where the view begins

const float FOUR_PI = 12.5663706;
const float BRIGHTEST = 0.397887358; // mean diffuse radiance deep under a side that is lit at a right angle
const float OBLIQUITY = 0.666666667; // distance from a side along its normal, divided by that along a ray, on the mean
const float OPAQUE = 0.01;
const float GROWTH = 0.01; // metres of a step per metre of distance
const float FARTHEST = 32.0; // distance that cloudDensity's 1 means, cells
const float SEPARATIONS = 64.0;
const float DEPTHS = 64.0;

struct CloudRay {
    float transmittance;
    float sunlight; // per irradiance
    float above; // share of the upper sky's mean radiance
    float below;
    float metres; // of the part that is seen
};

// The part of a ray of unit direction in the cloud's boxes.
vec2 insideCloud(vec3 ray) {
    float widest = pow(WIDENING, cells.z - 1.0);
    vec2 planet = vec2(phase.z, stepping.z);
    vec2 inside = spanInside(ray, cloudBase, cloudHalf * vec3(widest, 1.0, widest), planet);
    return vec2(inside.x, min(inside.y, planetMetres(ray, planet)));
}

#ifdef NOISE
#include "cloud-noise.glsl"
#endif

float cellDensity(vec4 cell) {
    return mix(cell.r, cell.a, cells.w);
}

vec4 lightOf(vec3 place, float height, float box) {
    vec3 texel = texelOf(place, height, box, cells.y);
    vec4 light = textureLod(cloudLight, texel, 0.0);
    return cells.w > 0.0 ? mix(light, textureLod(cloudLightToCome, texel, 0.0), cells.w) : light;
}

vec4 lightAt(vec3 place, float height) {
    vec2 box = boxOf(place);
    vec4 light = lightOf(place, height, box.x);
    return box.y > 0.0 ? mix(light, lightOf(place, height, box.x + 1.0), box.y) : light;
}

// Light that turns once by any angle or often by small ones, per optical depth.
// column: of the separation in smallAngles
float smallAngleLight(float column, float depth) {
    float row = sqrt(min(1.0, depth * phase.y)) * ((DEPTHS - 1.0) / DEPTHS) + 0.5 / DEPTHS;
    return textureLod(smallAngles, vec2(column, row), 0.0).r;
}

#ifdef OCTAVES
float henyeyGreenstein(float g, float separation) {
    float squared = (1.0 - g) * (1.0 - g) + g * separation;
    return (1.0 - g) * (1.0 + g) / (FOUR_PI * squared * sqrt(squared));
}

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

// direction: of unit length; visible: the part of the ray in the cloud that no surface hides
CloudRay marchedCloud(vec3 direction, vec2 visible, float offset) {
    CloudRay ray = CloudRay(1.0, 0.0, 0.0, 0.0, 0.0);
    float scaled = 1.0;
    float eyeDepth = 0.0;
    float exitLight = 0.0;
    float lastDiffuse = 0.0;
    vec3 apart = direction - cloudSun;
    float separation = dot(apart, apart);
    float cosine = 1.0 - 0.5 * separation;
    float column = sqrt(sqrt(0.25 * separation)) * ((SEPARATIONS - 1.0) / SEPARATIONS) + 0.5 / SEPARATIONS;
    float once = (1.0 + 3.0 * phase.x * cosine) / FOUR_PI;
    float axisCosine = -dot(direction, diffuseAxis.xyz);
    float resistance = 0.75 * (1.0 - phase.x) * medium.y; // to diffuse light, per optical depth
    vec2 planet = vec2(phase.z, stepping.z);
    float at = visible.x;
    float share = offset;
    while (at < visible.y && scaled > OPAQUE) {
        float stepMetres = stepping.x * max(cellEdges.w, GROWTH * at);
        float from = at;
        float to = min(at + share * stepMetres, visible.y);
        float middle = 0.5 * (from + to);
        vec3 place = middle * direction;
        float height = heightAbove(direction, middle, planet);
        vec2 box = boxOf(place);
        vec4 cell = textureLod(cloudDensity, texelOf(place, height, box.x, cells.x), 0.0);
        at = to;
        share = 1.0;
        if (cell.g * FARTHEST >= 1.0) {
            // Whole steps, so that the samples of neighbouring rays stay side by side.
            vec3 edges = cellEdges.xyz * vec3(1.0, 0.0, 1.0) * pow(WIDENING, box.x) + vec3(0.0, cellEdges.y, 0.0);
            vec3 perMetre = abs(direction) / edges;
            float emptyMetres = cell.g * FARTHEST / max(perMetre.x, max(perMetre.y, perMetre.z));
            at += stepMetres * max(0.0, floor(emptyMetres / stepMetres - 1.0));
            continue;
        }
#ifdef NOISE
        float density = noiseDensity(vec3(place.x, height, place.z), box);
#else
        float density = cellDensity(cell);
        if (box.y > 0.0) {
            vec4 wider = textureLod(cloudDensity, texelOf(place, height, box.x + 1.0, cells.x), 0.0);
            density = mix(density, cellDensity(wider), box.y);
        }
#endif
        if (density <= 0.0) {
            continue;
        }
        float depth = density * medium.x * (to - from);
        float mean = meanDepth(depth);
        float lit = from + mean / max(depth, 1e-20) * (to - from);
        vec4 light = lightAt(lit * direction, heightAbove(direction, lit, planet));
        float taken = takenBy(depth);
        float scaledTaken = takenBy(medium.y * depth);
#ifdef OCTAVES
        ray.sunlight += ray.transmittance * taken * medium.z * octaves(separation, light.r);
#else
        float narrow = smallAngleLight(column, light.r + eyeDepth + mean) * taken * exp(mean);
        float beam = exp(-medium.y * light.r);
        // Between the sides towards the sun and towards the eye the light is no brighter than in a slab between them.
        exitLight = ray.transmittance == 1.0 ? beam : exitLight;
        float toSun = 1.0 + resistance * OBLIQUITY * light.r;
        float toEye = 1.0 + resistance * (stepping.w + eyeDepth + mean);
        float kept = min(1.0, BRIGHTEST * (toEye + exitLight * toSun) / ((toEye + toSun) * max(light.g, 1e-10)));
        float slope = cosine * clamp(diffuseAxis.w * beam, -light.g, light.g) + axisCosine * light.b;
        lastDiffuse = medium.w * (once * beam + kept * max(0.0, light.g + phase.x * slope));
        eyeDepth += depth;
        ray.sunlight += narrow + scaled * scaledTaken * lastDiffuse;
#endif
        float seen = ray.transmittance * taken;
        ray.above += seen * medium.z * light.a;
        ray.below += seen * medium.z * (cell.b - light.a);
        ray.metres += seen * middle;
        ray.transmittance -= seen;
        scaled *= 1.0 - scaledTaken;
    }
    float covered = 1.0 - ray.transmittance;
    ray.metres /= max(covered, 1e-6);
    if (scaled <= OPAQUE) {
        // What is behind is taken as the last step, so that the early end loses no light.
        ray.sunlight += scaled * lastDiffuse;
        ray.above /= covered;
        ray.below /= covered;
        ray.transmittance = 0.0;
    }
    ray.sunlight = max(0.0, ray.sunlight);
    return ray;
}
