// Fog in front of a mirror, which the mirror does not tint: its reflection was multiplied by the tint, all fog
// included.
#include "frame.glsl"
#include "fog.glsl"

uniform vec3 keptBack; // share of radiance that the mirror absorbs, times the tint of the view that shows it

in vec3 picturePosition; // of the opening in this view: across and up in the picture times metres, metres

layout(location = 0) out vec4 pixel;

void main() {
    vec3 relativePosition =
            picturePosition.x * viewRight.xyz + picturePosition.y * viewUp.xyz + picturePosition.z * viewForward.xyz;
    pixel = vec4(keptBack * behindFog(vec3(0.0), relativePosition), 0.0);
}
