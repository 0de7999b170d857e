// How a surface shader leaves its radiance: render.frame.Output decides.
#include "frame.glsl"
#ifdef FOG
#include "fog.glsl"
#endif
#ifdef OUTPUT_DIRECT
#include "tone-mapping.glsl"
#endif

layout(location = 0) out vec4 pixel;

void writeRadiance(vec3 radiance) {
#ifdef MIRRORS
    radiance *= mirrorTint.rgb;
#endif
#if defined(OUTPUT_PLAIN)
    pixel = vec4(radiance, 1.0);
#elif defined(OUTPUT_HDR)
    pixel = vec4(clamp(radiance, 0.0, 65504.0), 1.0);
#else
    pixel = vec4(develop(radiance), 1.0);
#endif
}

// Radiance of a surface, with what lies between it and the eye. Behind an opening the eye is a virtual one, as far from the
// surface as the whole way is long.
void writeRadiance(vec3 radiance, vec3 relativePosition) {
#ifdef FOG
    writeRadiance(behindFog(radiance, fog, length(relativePosition)));
#else
    writeRadiance(radiance);
#endif
}
