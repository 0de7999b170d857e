// Marches a ray through the cells of a cloud. Twin: nephele.engine.cloud.cells.CellMarch.

uniform sampler3D cloudDensity; // r: density, g: distance to the nearest cell with some, b: light that absorption leaves
uniform sampler3D cloudLight; // sun-ward depth, diffuse mean, diffuse slope, share from above
uniform sampler2D smallAngles; // by separation and depth
uniform vec3 boxMin; // relative to the eye, metres
uniform vec3 boxSize; // metres
uniform vec4 medium; // greatest extinction per metre; scaled divided by true depth; albedo; scaled albedo
uniform vec4 phase; // scaled cosine; deepest optical depth of smallAngles
uniform vec3 cloudSun; // towards the sun
uniform vec3 stepping; // metres of a step, metres of a distance of one cell, place of the first sample in its step

const float FOUR_PI = 12.5663706;
const float OPAQUE = 0.01;
const float FARTHEST = 32.0;
const float SEPARATIONS = 64.0;
const float DEPTHS = 64.0;

struct CloudRay {
    float transmittance;
    float sunlight; // per irradiance
    float above; // share of the upper sky's mean radiance
    float below;
    float metres; // of the part that is seen
};

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

// direction: of unit length
CloudRay marchedCloud(vec3 direction, vec2 visible, float offset) {
    CloudRay ray = CloudRay(1.0, 0.0, 0.0, 0.0, 0.0);
    float scaled = 1.0;
    float lastDiffuse = 0.0;
    vec3 apart = direction - cloudSun;
    float separation = dot(apart, apart);
    float cosine = 1.0 - 0.5 * separation;
    float once = (1.0 + 3.0 * phase.x * cosine) / FOUR_PI;
    vec3 start = -boxMin / boxSize;
    vec3 along = direction / boxSize;
    float at = visible.x - offset * stepping.x;
    while (at < visible.y && scaled > OPAQUE) {
        float from = max(at, visible.x);
        float to = min(at + stepping.x, visible.y);
        vec3 cell = textureLod(cloudDensity, start + 0.5 * (from + to) * along, 0.0).rgb;
        at += stepping.x;
        if (cell.r <= 0.0) {
            // Whole steps, so that the samples of neighbouring rays stay side by side.
            at += stepping.x * floor(cell.g * stepping.y / stepping.x);
            continue;
        }
        float depth = cell.r * medium.x * (to - from);
        float mean = meanDepth(depth);
        vec4 light = textureLod(cloudLight, start + (from + mean / depth * (to - from)) * along, 0.0);
        float taken = 1.0 - exp(-depth);
        float scaledTaken = 1.0 - exp(-medium.y * depth);
        float eyeDepth = -log(max(ray.transmittance, 1e-30));
        float narrow = smallAngleLight(separation, light.r + eyeDepth + mean) * taken * exp(mean);
        lastDiffuse = medium.w * (once * exp(-medium.y * light.r) + max(0.0, light.g + phase.x * cosine * light.b));
        ray.sunlight += narrow + scaled * scaledTaken * lastDiffuse;
        float seen = ray.transmittance * taken;
        ray.above += seen * medium.z * light.a;
        ray.below += seen * medium.z * (cell.b - light.a);
        ray.metres += seen * 0.5 * (from + to);
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
