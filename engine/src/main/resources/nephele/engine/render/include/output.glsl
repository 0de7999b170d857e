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

// Reads a picture of a surface as finely as the picture shows it: more finely than a frame, if several are averaged.
#ifdef TEXTURE_BIAS
#define detailed(pictures, place) texture(pictures, place, TEXTURE_BIAS)
#else
#define detailed(pictures, place) texture(pictures, place)
#endif

layout(location = 0) out vec4 pixel;

// The alpha of surfaces and of the sky, see render.frame.FrameRequest.storesDistance.
#ifdef DISTANCE_STORED
#define SURFACE_ALPHA gl_FragCoord.w
const float SKY_ALPHA = 0.0;
#else
const float SURFACE_ALPHA = 1.0;
const float SKY_ALPHA = 1.0;
#endif

void writeRadiance(vec3 radiance) {
#ifdef MIRRORS
    radiance *= mirrorTint.rgb;
#endif
#if defined(OUTPUT_PLAIN)
    pixel = vec4(radiance, SURFACE_ALPHA);
#elif defined(OUTPUT_HDR)
    pixel = vec4(clamp(radiance, 0.0, 65504.0), SURFACE_ALPHA);
#else
    pixel = vec4(toneMapped(radiance, exposureFactor()), SURFACE_ALPHA);
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
    pixel.a = SKY_ALPHA;
}
