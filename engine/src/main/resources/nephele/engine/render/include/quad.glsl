// The corners of a quad for a ball of a cloud.
#include "frame.glsl"

layout(location = 0) in vec4 ball; // centre relative to the eye; deviation, metres
layout(location = 1) in vec4 peakAndCorner; // extinction in the centre per metre; corner

#ifndef WHOLE
noperspective out vec3 direction; // not of unit length; its part along the view's axis is 1
#endif

uniform float margin; // of a quad, as a share of its distance

const vec2 CORNERS[4] = vec2[](vec2(-1.0, -1.0), vec2(1.0, -1.0), vec2(1.0, 1.0), vec2(-1.0, 1.0));
const float LEAST_AHEAD = 0.05; // share of a ball's distance at which its corners have places in the picture

// Puts a corner of a quad. If the eye is in the ball, or a corner beside it, all pixels ask how near their ray comes, unless the
// ball is behind.
void putCorner(vec3 centre, vec3 corners[4], vec2 corner, bool isOutside, float radius) {
    float nearest = 1e30;
    for (int n = 0; n < 4; n++) {
        nearest = min(nearest, dot(corners[n], viewForward.xyz));
    }
    bool isQuad = isOutside && nearest > LEAST_AHEAD * length(centre);
    int number = corner.y < 0.0 ? (corner.x < 0.0 ? 0 : 1) : (corner.x < 0.0 ? 3 : 2);
    vec3 seen = isQuad ? corners[number] : shownDirection(corner);
    bool isBehind = dot(centre, viewForward.xyz) < -radius;
    if (isQuad) {
        gl_Position = clipFromRelative * vec4(seen, 1.0);
        gl_Position.z = 0.0;
    } else {
        gl_Position = isBehind ? vec4(2.0, 2.0, 2.0, 1.0) : vec4(corner, 0.0, 1.0);
    }
#ifndef WHOLE
    direction = seen / dot(seen, viewForward.xyz);
#endif
}
