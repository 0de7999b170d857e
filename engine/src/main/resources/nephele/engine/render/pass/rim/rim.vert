// A portal's rim, glow or area: built by render.pass.rim.RimShape in the portal's own axes.
#include "view-clip.glsl"

layout(location = 0) in vec4 edge; // a corner of the aperture, and its outward direction
layout(location = 1) in vec4 profile; // metres outwards, metres in front of the wall, share of the length of the edge

uniform vec4 centreAndOpenness; // the centre relative to the eye
uniform vec3 portalRight;
uniform vec3 portalUp;
uniform vec3 portalBack;

out vec3 rimPlace; // metres outside the edge, metres in front of the wall, share of the length of the edge
out vec2 areaPlace; // metres from the centre
out vec3 relativePosition;

void main() {
    // A new rim is thin as well as small.
    float grown = smoothstep(0.0, 0.4, centreAndOpenness.w);
    vec2 flatPlace = edge.xy * centreAndOpenness.w + edge.zw * profile.x * grown;
    vec3 relative = centreAndOpenness.xyz + portalRight * flatPlace.x + portalUp * flatPlace.y
        + portalBack * profile.y * grown;
    rimPlace = profile.xyz;
    areaPlace = flatPlace;
    relativePosition = relative;
    clipToView(relative);
    gl_Position = clipFromRelative * vec4(relative, 1.0);
}
