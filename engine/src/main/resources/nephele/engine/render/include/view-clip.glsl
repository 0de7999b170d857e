// Clips behind the opening through which a view looks; only if a level may have portals.
#include "frame.glsl"

void clipToView(vec3 relative) {
#ifdef PORTALS
    gl_ClipDistance[0] = dot(viewClip.xyz, relative) + viewClip.w;
#endif
}
