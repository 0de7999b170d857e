// The output of a surface shader's radiance, as render.frame.Output decides.
#include "frame.glsl"
#ifdef FOG
#include "fog.glsl"
#endif
#ifdef AIR
#include "air.glsl"
#endif
#ifdef OUTPUT_DIRECT
#include "exposure.glsl"
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
    pixel = vec4(toneMapped(radiance, exposureFactor()), 1.0);
#endif
}

// Writes what lies in front of a pixel without hiding it: premultiplied radiance and coverage, blended with what is behind.
// Directly, display values are blended instead of radiance.
void writeCovering(vec4 covering) {
#ifdef OUTPUT_DIRECT
    vec3 radiance = covering.rgb / max(covering.a, 1e-4);
    pixel = vec4(toneMapped(radiance, exposureFactor()) * covering.a, covering.a);
#else
    pixel = covering;
#endif
}

// Writes the radiance of a surface, with air and fog between it and the eye. Behind an opening the eye is a virtual one, at
// the distance of the whole path.
void writeRadiance(vec3 radiance, vec3 relativePosition) {
#ifdef AIR
    radiance = throughAir(radiance, relativePosition);
#endif
#ifdef FOG
    writeRadiance(behindFog(radiance, relativePosition));
#else
    writeRadiance(radiance);
#endif
}

// Writes the radiance of the sky, with fog between it and the eye. direction: not of unit length
void writeSky(vec3 radiance, vec3 direction) {
#ifdef FOG_LAYER
    radiance = mix(fog.rgb, radiance, skyThroughFog(direction));
#endif
    writeRadiance(radiance);
}
