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
    // Around a portal of the level it is as dim as lights a dark wall and shades a bright one.
    bool isShot = pattern.x < 1.5;
    writeRadiance(radianceOf(tintAndOpacity.rgb * (isShot ? 1.0 : 0.05)), relativePosition);
    float near = 1.0 - out01;
    pixel.a = breath * (isShot ? 0.5 * near * near : 0.95 * near * (1.0 + out01));
}
