// Marches a ray through the cells of a cloud. Twin: nephele.engine.cloud.cells.CellMarch.
#include "cloud-span.glsl"

// Boxes of cells stand on top of each other, the narrowest lowest.
uniform sampler3D cloudDensity; // r: density, g: distance to the nearest cell with some, b: light that absorption leaves
uniform sampler3D cloudLight; // sun-ward depth, diffuse mean, diffuse slope, share from above
uniform sampler2D smallAngles; // by separation and depth
uniform vec4 cells; // x, y: rows of a box in cloudDensity and cloudLight; z: boxes; w: metres of a cell of the narrowest
uniform vec3 cloudBase; // middle of the narrowest box's lower side, relative to the eye, metres
uniform vec3 cloudHalf; // x, z: half of its sides; y: height of all boxes, metres
uniform vec4 medium; // greatest extinction per metre; scaled divided by true depth; albedo; scaled albedo
uniform vec3 phase; // scaled cosine; deepest optical depth of smallAngles; 1 / twice the planet's radius, 0 if flat
uniform vec3 cloudSun; // towards the sun
uniform vec3 stepping; // cells of a step; place of the first sample in its step; the eye's height over a round planet

const float FOUR_PI = 12.5663706;
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
    float widest = exp2(2.0 * (cells.z - 1.0));
    vec2 inside = spanInside(ray, cloudBase, cloudHalf * vec3(widest, 1.0, widest), phase.z);
    if (phase.z > 0.0 && stepping.z >= 0.0) {
        inside.y = min(inside.y, sooner(dot(ray.xz, ray.xz) * phase.z, ray.y, stepping.z)); // the planet hides the rest
    }
    return inside;
}

// Which cells are around a place.
float boxOf(vec3 place) {
    vec2 apart = abs(place.xz - cloudBase.xz) / cloudHalf.xz;
    float wide = max(apart.x, apart.y);
    return wide <= 1.0 ? 0.0 : min(cells.z - 1.0, ceil(0.5 * log2(wide) - 1e-6));
}

#ifdef NOISE
#include "cloud-noise.glsl"
#endif

// The coordinates of a place in a stack of boxes of so many rows.
vec3 texelOf(vec3 place, float bend, float at, float rows) {
    float box = boxOf(place);
    vec2 across = (place.xz - cloudBase.xz) / (2.0 * cloudHalf.xz) * exp2(-2.0 * box) + 0.5;
    float up = clamp((place.y + bend * at * at - cloudBase.y) / cloudHalf.y, 0.5 / rows, 1.0 - 0.5 / rows);
    return vec3(across.x, (box + up) / cells.z, across.y);
}

// Light that turns once by any angle or often by small ones, per optical depth.
float smallAngleLight(float separation, float depth) {
    vec2 place = vec2(sqrt(sqrt(0.25 * separation)), sqrt(min(1.0, depth / phase.y)));
    vec2 size = vec2(SEPARATIONS, DEPTHS);
    return textureLod(smallAngles, (place * (size - 1.0) + 0.5) / size, 0.0).r;
}

// Mean optical depth at which light that a step takes is taken.
float meanDepth(float depth) {
    float left = exp(-depth);
    return depth < 1e-2 ? 0.5 * depth : 1.0 - depth * left / (1.0 - left);
}

// direction: of unit length; visible: the part of the ray in the cloud that no surface hides
CloudRay marchedCloud(vec3 direction, vec2 visible, float offset) {
    CloudRay ray = CloudRay(1.0, 0.0, 0.0, 0.0, 0.0);
    float scaled = 1.0;
    float lastDiffuse = 0.0;
    vec3 apart = direction - cloudSun;
    float separation = dot(apart, apart);
    float cosine = 1.0 - 0.5 * separation;
    float once = (1.0 + 3.0 * phase.x * cosine) / FOUR_PI;
    float bend = dot(direction.xz, direction.xz) * phase.z;
    float at = visible.x;
    float share = offset;
    while (at < visible.y && scaled > OPAQUE) {
        float stepMetres = stepping.x * max(cells.w, GROWTH * at);
        float from = at;
        float to = min(at + share * stepMetres, visible.y);
        float middle = 0.5 * (from + to);
        vec3 cell = textureLod(cloudDensity, texelOf(middle * direction, bend, middle, cells.x), 0.0).rgb;
        at = to;
        share = 1.0;
#ifdef NOISE
        bool isEmpty = cell.g * FARTHEST >= 1.0;
#else
        bool isEmpty = cell.r <= 0.0;
#endif
        if (isEmpty) {
            // Whole steps, so that the samples of neighbouring rays stay side by side.
            float emptyMetres = cell.g * FARTHEST * cells.w * exp2(2.0 * boxOf(middle * direction));
            at += stepMetres * max(0.0, floor(emptyMetres / stepMetres - 1.0));
            continue;
        }
#ifdef NOISE
        float density = noiseDensity(middle * direction, bend * middle * middle);
        if (density <= 0.0) {
            continue;
        }
#else
        float density = cell.r;
#endif
        float depth = density * medium.x * (to - from);
        float mean = meanDepth(depth);
        float lit = from + mean / max(depth, 1e-20) * (to - from);
        vec4 light = textureLod(cloudLight, texelOf(lit * direction, bend, lit, cells.y), 0.0);
        float taken = 1.0 - exp(-depth);
        float scaledTaken = 1.0 - exp(-medium.y * depth);
        float eyeDepth = -log(max(ray.transmittance, 1e-30));
        float narrow = smallAngleLight(separation, light.r + eyeDepth + mean) * taken * exp(mean);
        lastDiffuse = medium.w * (once * exp(-medium.y * light.r) + max(0.0, light.g + phase.x * cosine * light.b));
        ray.sunlight += narrow + scaled * scaledTaken * lastDiffuse;
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
