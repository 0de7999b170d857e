// A flat picture of a ball of a cloud. It fades where a surface or the eye is in the ball.
#include "cloud-pixel.glsl"
#include "puff.glsl"

flat in vec4 puff;
flat in float peak;
flat in vec3 across;
flat in vec3 upwards;
flat in float flatness;
flat in vec2 depths;
in float straight;
in vec2 sun;
in vec3 sky;

uniform vec4 medium; // y: scaled divided by true depth
uniform vec3 irradiance; // of the sun at the cloud

float takenBy(float depth) {
    return depth < 1e-2 ? depth * (1.0 - depth * (0.5 - depth / 6.0)) : 1.0 - exp(-depth);
}

#include "puff-sum.glsl"

// Optical depth of the picture, and its distance.
vec2 pictureDepth(CloudPixel at) {
    vec3 normal = cross(across, upwards);
    float facing = dot(at.ray, normal);
    float metres = dot(puff.xyz, normal) / (abs(facing) > 1e-6 ? facing : 1e-6);
    vec3 place = metres * at.ray - puff.xyz;
    float unit = ROOT_2 * puff.w;
    float aside = dot(place, place) / (unit * unit);
    if (!(metres > 0.0) || aside > 0.5 * CUT * CUT) {
        return vec2(0.0, max(0.0, metres));
    }
    float seen = errorFunction((at.visible.y - metres) / unit) - errorFunction((at.visible.x - metres) / unit);
    return vec2(peak * puff.w * ROOT_HALF_PI * exp(-aside) * max(0.0, seen), metres);
}

// Optical depth of the ball itself, and its distance.
vec2 ballDepth(CloudPixel at) {
    PuffPart part = puffPart(puff.xyz, puff.w, peak, at.ray, at.visible);
    return vec2(part.depth, clamp(part.nearest, 0.0, at.visible.y));
}

void main() {
    CloudPixel at = cloudPixel();
    vec2 picture = flatness > 0.0 ? pictureDepth(at) : vec2(0.0);
    if (flatness < 1.0) {
        picture = mix(ballDepth(at), picture, flatness);
    }
    if (!(picture.x > 1e-7)) {
        discard;
    }
    float covered = takenBy(picture.x);
    vec3 radiance = puffRadiance(sun, sky, irradiance, depths.x + picture.x, vec2(depths.y, straight), medium.y);
    writeCloud(at, covered * radiance, covered, picture.y);
}
