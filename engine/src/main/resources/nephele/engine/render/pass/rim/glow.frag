// Light of a rim on the wall beside it.
#include "output.glsl"
#include "displayed.glsl"

in vec3 rimPlace;
in vec2 areaPlace;
in vec3 relativePosition;

uniform vec4 tintAndOpacity;
uniform vec4 pattern;

const float START = 0.1;
const float WIDTH = 0.13;

void main() {
    float out01 = clamp((rimPlace.x - START) / WIDTH, 0.0, 1.0);
    float breath = 0.9 + 0.1 * sin(6.2831853 * (pattern.z * 0.25 + rimPlace.z));
    writeRadiance(radianceOf(tintAndOpacity.rgb), relativePosition);
    pixel.a = 0.5 * (1.0 - out01) * (1.0 - out01) * breath;
}
