// For each of 16 distances along a pixel's ray, the share of the air's light, scattered once, that clouds take on the way
// to the points up to there.
#include "output.glsl"
#include "cell-boxes.glsl"
#include "cloud-span.glsl"

in vec3 direction;

layout(location = 1) out vec4 second;
layout(location = 2) out vec4 third;
layout(location = 3) out vec4 fourth;

// Where the light's ray to a place crosses the base of the clouds, and the height of the place: the share of the light
// that clouds take at the last (r) and the next (g) sampled time. Its cells begin and end half a row beyond base and top.
uniform sampler3D shade;
uniform vec3 slant; // xy: how far the light goes along x and z per metre of height; z: of the shafts, 0 to 1
uniform vec2 planet; // of spanInside

const int STEPS = 6; // from one distance to the next
const vec3 LUMINANCE = java(level.appearance.LuminanceHistogram.LUMINANCE);

float metresTo(int distance) {
    float root = float(distance) / SHAFT_DISTANCES;
    float range = root * root * AIR_FARTHEST;
    return AIR_MIDDLE * range / (1.0 - range);
}

float shadeAt(vec3 ray, float metres, float halfRow) {
    float height = heightAbove(ray, metres, planet);
    vec3 foot = metres * ray;
    foot.xz -= slant.xy * (height - cloudBase.y - halfRow);
    vec2 box = boxOf(foot);
    vec2 taken = textureLod(shade, texelOf(foot, height, box.x, cells.x), 0.0).rg;
    if (box.y > 0.0) {
        taken = mix(taken, textureLod(shade, texelOf(foot, height, box.x + 1.0, cells.x), 0.0).rg, box.y);
    }
    return mix(taken.r, taken.g, cells.w);
}

void main() {
    vec3 ray = normalize(direction);
    float halfRow = 0.5 * cloudHalf.y / cells.x;
    float top = cloudBase.y + cloudHalf.y - halfRow;
    float heightBefore = 0.0;
    float before = 0.0;
    float all = 0.0;
    float taken = 0.0;
    vec4 shares[4];
    for (int k = 0; k < int(SHAFT_DISTANCES); k++) {
        float from = metresTo(k);
        float to = metresTo(k + 1);
        float height = heightAbove(ray, to, planet);
        int steps = min(heightBefore, height) < top ? STEPS : 0;
        heightBefore = height;
        float sum = 0.0;
        for (int n = 0; n < steps; n++) {
            sum += shadeAt(ray, mix(from, to, (float(n) + 0.5) / float(STEPS)), halfRow);
        }
        float upTo = dot(LUMINANCE, scatteredOnce(airPathTo(to * ray)));
        float more = max(0.0, upTo - before);
        before = upTo;
        all += more;
        taken += more * sum / float(STEPS);
        shares[k / 4][k & 3] = slant.z * taken / max(all, 1e-30);
    }
    pixel = shares[0];
    second = shares[1];
    third = shares[2];
    fourth = shares[3];
}
