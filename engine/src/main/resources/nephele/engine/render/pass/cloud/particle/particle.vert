// A quad that covers a ball of a cloud, and what the cells of the cloud have in front of it and behind.
#include "frame.glsl"
#include "cloud-march.glsl"
#include "puff.glsl"

layout(location = 0) in vec4 ball; // centre relative to the eye; deviation, metres
layout(location = 1) in vec4 peakAndCorner; // extinction in the centre per metre; corner

uniform float margin; // of a quad, as a share of its distance

flat out vec4 puff;
flat out float peak;
flat out vec2 depths; // of the cloud in front of the ball and behind it, on the ray through its centre

#ifndef WHOLE
noperspective out vec3 direction; // not of unit length; its part along the view's axis is 1
#endif

const int STEPS = 24;

vec2 depthsBeside(vec3 ray, vec2 span) {
    vec2 inside = insideCloud(ray);
    inside.x = max(0.0, inside.x);
    float stepMetres = (inside.y - inside.x) / float(STEPS);
    vec2 sums = vec2(0.0);
    for (int n = 0; n < STEPS && stepMetres > 0.0; n++) {
        float at = inside.x + (float(n) + 0.5) * stepMetres;
        vec3 place = at * ray;
        vec4 cell = textureLod(cloudDensity, texelOf(place, place.y, 0.0, cells.x), 0.0);
        float depth = cellDensity(cell) * medium.x * stepMetres;
        sums += depth * vec2(at < span.x ? 1.0 : 0.0, at > span.y ? 1.0 : 0.0);
    }
    return sums;
}

// The corner of a quad that touches the cone around the ball, relative to the eye.
vec3 cornerAround(vec2 corner, float radius, float metres) {
    vec3 towards = puff.xyz / metres;
    vec3 across = normalize(cross(towards, abs(towards.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0)));
    float size = radius * metres / sqrt(metres * metres - radius * radius) + margin * metres;
    return puff.xyz + size * (corner.x * across + corner.y * cross(across, towards));
}

// Whether all of a quad is in front of the eye, so that its corners have places in the picture.
bool isAhead(float radius, float metres) {
    float nearest = 1e30;
    for (int n = 0; n < 4; n++) {
        vec2 corner = vec2(n % 2 == 0 ? -1.0 : 1.0, n < 2 ? -1.0 : 1.0);
        nearest = min(nearest, dot(cornerAround(corner, radius, metres), viewForward.xyz));
    }
    return nearest > 0.05 * metres;
}

void main() {
    puff = ball;
    peak = peakAndCorner.x;
    vec2 corner = peakAndCorner.yz;
    float radius = puffRadius(puff.w, peak);
    float metres = length(puff.xyz);
    vec3 seen;
    if (metres > 1.01 * radius && isAhead(radius, metres)) {
        seen = cornerAround(corner, radius, metres);
        gl_Position = clipFromRelative * vec4(seen, 1.0);
        gl_Position.z = 0.0;
    } else {
        // Around the eye or beside it: all pixels ask how near their ray comes, unless the ball is behind.
        bool isBehind = dot(puff.xyz, viewForward.xyz) < -radius;
        seen = viewForward.xyz + corner.x * viewRight.xyz + corner.y * viewUp.xyz;
        gl_Position = isBehind ? vec4(2.0, 2.0, 2.0, 1.0) : vec4(corner, 0.0, 1.0);
    }
#ifndef WHOLE
    direction = seen / dot(seen, viewForward.xyz);
#endif
    depths = depthsBeside(puff.xyz / max(metres, 1e-6), metres + vec2(-MOST_DEVIATIONS, MOST_DEVIATIONS) * puff.w);
}
