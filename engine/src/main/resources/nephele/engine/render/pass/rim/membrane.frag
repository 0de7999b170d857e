// Covers the wall within the rim of a portal without a partner, and the sky in an open one whose view is not drawn.
#include "output.glsl"
#include "displayed.glsl"
#include "closed-look.glsl"

in vec2 areaPlace;
in vec3 relativePosition;

uniform vec4 tintAndOpacity;
uniform vec4 pattern;

void main() {
    writeRadiance(radianceOf(closedLook(areaPlace, pattern.w, tintAndOpacity.rgb, pattern.z)), relativePosition);
    pixel.a = OPACITY;
}
