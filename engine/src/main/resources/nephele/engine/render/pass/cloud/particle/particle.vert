// A quad that covers a ball of a cloud, and what the cells of the cloud have in front of it and behind.
#include "frame.glsl"
#include "puff-light.glsl"
#include "quad.glsl"

flat out vec4 puff;
flat out float peak;
#ifndef BEAM
flat out vec2 depths; // of the cloud in front of the ball and behind it, on the ray through its centre
#endif

// The corner of a quad that touches the cone around the ball, relative to the eye.
vec3 cornerAround(vec2 corner, vec4 ball, float radius, float metres) {
    vec3 towards = ball.xyz / metres;
    vec3 across = normalize(cross(towards, abs(towards.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0)));
    float size = radius * metres / sqrt(metres * metres - radius * radius) + margin * metres;
    return ball.xyz + size * (corner.x * across + corner.y * cross(across, towards));
}

void main() {
    puff = ball;
    peak = peakAndCorner.x;
    float radius = puffRadius(puff.w, peak);
    float metres = length(puff.xyz);
    bool isOutside = metres > 1.01 * radius;
    vec3 corners[4];
    for (int n = 0; n < 4; n++) {
        corners[n] = isOutside ? cornerAround(CORNERS[n], ball, radius, metres) : vec3(0.0);
    }
    putCorner(puff.xyz, corners, peakAndCorner.yz, isOutside, radius);
#ifndef BEAM
    depths = depthsBeside(puff.xyz / max(metres, 1e-6), metres + vec2(-MOST_DEVIATIONS, MOST_DEVIATIONS) * puff.w);
#endif
}
