// A prism around an exit's cylinder; its back faces cover every pixel that sees the cylinder, also from inside.
#include "view-clip.glsl"
#include "exits.glsl"

layout(location = 0) in vec3 place; // x and z on a circle around the unit circle, y from 0 to 1

uniform int drawnExit;

out vec3 relativePosition;

void main() {
    vec4 at = feetAndRadius[drawnExit];
    relativePosition = at.xyz + place * vec3(at.w, heightMetres[drawnExit], at.w);
    clipToView(relativePosition);
    gl_Position = clipFromRelative * vec4(relativePosition, 1.0);
}
