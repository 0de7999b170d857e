// Finds edges of display values: between a pixel and its left and lower neighbours. The same edges of the lower and of the
// left neighbour go with them, so that a search along an edge reads one texel a step.

uniform sampler2D displayed;

layout(location = 0) out vec4 edges; // left, lower; left of the lower neighbour, lower of the left neighbour

const float LEAST_DIFFERENCE = 0.12;

vec3 at(ivec2 pixel) {
    return texelFetch(displayed, max(pixel, ivec2(0)), 0).rgb;
}

float isEdge(vec3 a, vec3 b) {
    vec3 difference = abs(a - b);
    return step(LEAST_DIFFERENCE, max(difference.r, max(difference.g, difference.b)));
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 here = at(pixel);
    vec3 left = at(pixel - ivec2(1, 0));
    vec3 lower = at(pixel - ivec2(0, 1));
    vec3 corner = at(pixel - ivec2(1, 1));
    edges = vec4(isEdge(here, left), isEdge(here, lower), isEdge(lower, corner), isEdge(left, corner));
}
