// A flat picture of a ball of a cloud, turned by FACING, with light that is linear across it.
#include "puff-light.glsl"
#include "quad.glsl"

flat out vec4 puff;
flat out float peak;
flat out vec3 across; // axes of the picture
flat out vec3 upwards;
flat out float flatness; // 0 where the eye is too near for a picture and sees the ball itself
flat out vec2 depths; // of the cloud besides, and how fast narrow light fades
out float straight; // depth on which that light can lie
out vec2 sun; // narrow and diffuse sunlight
out vec3 sky;

const vec3 UP = vec3(0.0, 1.0, 0.0);
// Places in the picture at whose distance from the centre it is lit, deviations.
const float LIT_ASIDE = 1.0;

// Turned about an upright axis, then tilted, by the angles of a source of 2004: yaw from x and z alone, divided by the
// difference in x, and pitch from y and z alone. Wrong beside the axes, and undefined on them.
void turnAsSource() {
    float yaw = atan(puff.z / puff.x);
    float pitch = atan(puff.y / puff.z);
    vec3 ahead = vec3(cos(yaw) * cos(pitch), sin(pitch), sin(yaw) * cos(pitch));
    across = vec3(-sin(yaw), 0.0, cos(yaw));
    upwards = cross(across, ahead);
}

void turn(vec3 towards) {
    vec3 right = normalize(viewRight.xyz);
    vec3 level = cross(towards, UP);
    float sine = length(level);
#if FACING == 0
    across = right;
    upwards = normalize(viewUp.xyz);
#elif FACING == 3
    turnAsSource();
#else
    // Straight above and below, any direction across is right.
    across = sine > 1e-4 ? level / sine : right;
    upwards = FACING == 1 ? normalize(cross(across, towards)) : UP;
#endif
}

void main() {
    puff = ball;
    peak = peakAndCorner.x;
    float radius = puffRadius(puff.w, peak);
    float metres = length(puff.xyz);
    vec3 towards = puff.xyz / max(metres, 1e-6);
    turn(towards);
    bool isOutside = metres > 1.01 * radius;
    flatness = smoothstep(1.01 * radius, 2.0 * radius, metres);
    // The cone around the ball while that is still seen.
    float wider = flatness < 1.0 && isOutside ? metres / sqrt(metres * metres - radius * radius) : 1.0;
    float size = wider * radius + margin * metres;
    vec3 corners[4];
    for (int n = 0; n < 4; n++) {
        corners[n] = puff.xyz + size * (CORNERS[n].x * across + CORNERS[n].y * upwards);
    }
    putCorner(puff.xyz, corners, peakAndCorner.yz, isOutside, radius);
    float own = puff.w * peak * 2.0 * ROOT_HALF_PI;
    vec2 beside = depthsBeside(towards, metres + vec2(-MOST_DEVIATIONS, MOST_DEVIATIONS) * puff.w);
    vec2 aside = flatness * LIT_ASIDE * puff.w * peakAndCorner.yz;
    // About as far as half of the diffuse light comes from: the denser the ball, the nearer to its front.
    float nearer = min(sqrt(2.0 * log(1.0 + 0.5 * medium.y * own)) * puff.w, 0.5 * metres);
    vec3 middle = puff.xyz - nearer * towards;
    float toEye = beside.x + min(0.5 * own, 0.5);
    PuffLight lit = puffLight(middle, towards, toEye);
    PuffLight besides = puffLight(middle + aside.x * across, towards, toEye);
    PuffLight over = puffLight(middle + aside.y * upwards, towards, toEye);
    // Linear across the picture: its two triangles would otherwise show on which diagonal they meet.
    depths = vec2(beside.x + beside.y, narrowFading(towards));
    sun = max(vec2(0.0), vec2(besides.narrow + over.narrow - lit.narrow, besides.diffuse + over.diffuse - lit.diffuse));
    straight = max(0.0, besides.straight + over.straight - lit.straight);
    sky = max(vec3(0.0), besides.sky + over.sky - lit.sky);
}
