// Morphological antialiasing: an edge of the pixel grid is read as a straight line between the crossing edges at its ends,
// and each pixel takes as much of its neighbour across the edge as lies on the other side of that line (Reshetov 2009,
// "Morphological Antialiasing"; Jimenez et al. 2012, "SMAA: Enhanced Subpixel Morphological Antialiasing", sections 3 and
// 4; areas are computed, not looked up). Light is mixed linearly.

uniform sampler2D displayed;
#include "surrounding-edges.glsl"
#include "line-area.glsl"

layout(location = 0) out vec4 pixel;

const int FARTHEST = 16; // pixels to each side

vec3 linearOf(vec3 encoded) {
    vec3 power = pow((encoded + 0.055) / 1.055, vec3(2.4));
    return mix(encoded / 12.92, power, greaterThan(encoded, vec3(0.04045)));
}

vec3 encodedOf(vec3 linear) {
    vec3 power = 1.055 * pow(max(linear, 1e-5), vec3(1.0 / 2.4)) - 0.055;
    return mix(12.92 * linear, power, greaterThan(linear, vec3(0.0031308)));
}

// Returns which side of a lower edge is crossed at the left end of a pixel: 1 the pixel's own, -1 the one below. A crossing
// edge of two pixels is a corner or the longer step of a steep line, and counts as none.
float crossedLower(ivec2 at, vec4 e) {
    return e.r * (1.0 - edgesAt(at + ivec2(0, 1)).r) - e.b * (1.0 - edgesAt(at - ivec2(0, 1)).b);
}

// The same for a left edge at the lower end of a pixel: 1 the pixel's own side, -1 the one to the left.
float crossedLeft(ivec2 at, vec4 e) {
    return e.g * (1.0 - edgesAt(at + ivec2(1, 0)).g) - e.a * (1.0 - edgesAt(at - ivec2(1, 0)).a);
}

// Searches along the lower edge of a pixel. Returns the number of pixels of the edge to each side, and which sides are
// crossed at the ends, as for areaBeyond.
vec4 alongLower(ivec2 at) {
    int before = 0;
    vec4 e = edgesAt(at);
    while (before < FARTHEST && e.r + e.b == 0.0 && e.a > 0.0) {
        before++;
        e = edgesAt(at - ivec2(before, 0));
    }
    float atStart = crossedLower(at - ivec2(before, 0), e);
    int after = 0;
    e = edgesAt(at + ivec2(1, 0));
    while (after < FARTHEST && e.r + e.b == 0.0 && e.g > 0.0) {
        after++;
        e = edgesAt(at + ivec2(after + 1, 0));
    }
    return vec4(before, after, atStart, crossedLower(at + ivec2(after + 1, 0), e));
}

// The same along the left edge of a pixel.
vec4 alongLeft(ivec2 at) {
    int before = 0;
    vec4 e = edgesAt(at);
    while (before < FARTHEST && e.g + e.a == 0.0 && e.b > 0.0) {
        before++;
        e = edgesAt(at - ivec2(0, before));
    }
    float atStart = crossedLeft(at - ivec2(0, before), e);
    int after = 0;
    e = edgesAt(at + ivec2(0, 1));
    while (after < FARTHEST && e.g + e.a == 0.0 && e.r > 0.0) {
        after++;
        e = edgesAt(at + ivec2(0, after + 1));
    }
    return vec4(before, after, atStart, crossedLeft(at + ivec2(0, after + 1), e));
}

vec4 light(ivec2 at, ivec2 across, vec4 line) {
    float area = areaBeyond(line.x, line.y, line.z, line.w);
    return area * vec4(linearOf(texelFetch(displayed, at + across, 0).rgb), 1.0);
}

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec4 sum = vec4(0.0);
    vec4 isEdge = surroundingEdges(at);
    if (isEdge.x > 0.0) {
        sum += light(at, ivec2(-1, 0), alongLeft(at));
    }
    if (isEdge.y > 0.0) {
        sum += light(at, ivec2(0, -1), alongLower(at));
    }
    if (isEdge.z > 0.0) {
        vec4 line = alongLeft(at + ivec2(1, 0));
        sum += light(at, ivec2(1, 0), vec4(line.xy, -line.zw));
    }
    if (isEdge.w > 0.0) {
        vec4 line = alongLower(at + ivec2(0, 1));
        sum += light(at, ivec2(0, 1), vec4(line.xy, -line.zw));
    }
    vec3 here = texelFetch(displayed, at, 0).rgb;
    if (sum.a > 0.0) {
        here = encodedOf(mix(linearOf(here), sum.rgb / sum.a, min(sum.a, 1.0)));
    }
    pixel = vec4(here, 1.0);
}
