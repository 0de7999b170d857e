// A portal's opening as render.frame.OpeningMesh places it: depth as where openings are laid down, to the bit, and however
// near the eye is.
#include "frame.glsl"

layout(location = 0) in vec4 clipPosition;

uniform vec4 centreFromEye;
uniform vec3 portalRight;
uniform vec3 portalUp;

out vec2 areaPlace; // metres from the centre
out vec3 relativePosition;

invariant gl_Position;

void main() {
    relativePosition = clipPosition.w * viewForward.xyz + clipPosition.x * viewRight.xyz + clipPosition.y * viewUp.xyz;
    vec3 fromCentre = relativePosition - centreFromEye.xyz;
    areaPlace = vec2(dot(fromCentre, portalRight), dot(fromCentre, portalUp));
    gl_Position = clipPosition;
}
