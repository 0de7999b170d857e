// Cuts what lies behind the portal that a view looks out of; only where a level may have portals.
#include "frame.glsl"

void clipToView(vec3 relative) {
#ifdef PORTALS
    gl_ClipDistance[0] = dot(viewClip.xyz, relative) + viewClip.w;
#endif
}
