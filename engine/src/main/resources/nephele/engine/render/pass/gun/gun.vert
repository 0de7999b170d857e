// The portal gun before the eye, in front of all depths of the level.
#include "frame.glsl"

layout(location = 0) in vec3 position; // metres, in the gun's frame
layout(location = 1) in vec4 normalAndMaterial;

// The gun's axes and origin from the eye, as it is drawn.
uniform vec3 drawnRight;
uniform vec3 drawnUp;
uniform vec3 drawnBack;
uniform vec3 drawnPlace;
#ifndef ONLY_DEPTH
flat out float materialIndex;
out vec3 inGun;
out vec3 normalInGun;
#endif

const float DEPTH_SHARE = 0.05;

void main() {
    vec3 relative = drawnPlace + drawnRight * position.x + drawnUp * position.y + drawnBack * position.z;
    gl_Position = clipFromRelative * vec4(relative, 1.0);
    gl_Position.z = (gl_Position.z + gl_Position.w) * DEPTH_SHARE - gl_Position.w;
#ifndef ONLY_DEPTH
    inGun = position;
    normalInGun = normalAndMaterial.xyz;
    materialIndex = normalAndMaterial.w;
#endif
}
