// A portal's opening as render.resource.OpeningMesh places it: the same depth as in the opening's depth pass, at every
// distance of the eye.
#include "frame.glsl"

layout(location = 0) in vec4 clipPosition;

uniform vec4 centreAndOpenness;
uniform vec3 portalRight;
uniform vec3 portalUp;

out vec2 areaPlace; // metres from the centre
out vec3 relativePosition;

invariant gl_Position;

void main() {
    relativePosition = clipPosition.w * viewForward.xyz + clipPosition.x * viewRight.xyz + clipPosition.y * viewUp.xyz;
    vec3 fromCentre = relativePosition - centreAndOpenness.xyz;
    areaPlace = vec2(dot(fromCentre, portalRight), dot(fromCentre, portalUp));
    gl_Position = shifted(clipPosition);
}
