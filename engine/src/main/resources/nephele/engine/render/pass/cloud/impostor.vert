// A rectangle across the direction in which an impostor was captured.
#include "quad.glsl"

uniform vec3 quadCentre; // relative to the eye, metres
uniform vec3 quadAcross; // half of its sides
uniform vec3 quadUpwards;

void main() {
    vec3 corners[4];
    for (int n = 0; n < 4; n++) {
        corners[n] = quadCentre + CORNERS[n].x * quadAcross + CORNERS[n].y * quadUpwards;
    }
    putCorner(quadCentre, corners, peakAndCorner.yz, true, length(quadAcross) + length(quadUpwards));
}
