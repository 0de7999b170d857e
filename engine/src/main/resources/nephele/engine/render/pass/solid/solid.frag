#include "output.glsl"
#include "materials.glsl"
#include "lights.glsl"

#ifdef TEXTURED
uniform sampler2DArray colours;
in vec2 st;
flat in float colourLayer;
#endif
#ifdef FLAT_LIGHT
flat in vec3 reflectedPerAlbedo;
#else
flat in vec3 faceNormal;
flat in float materialIndex;
in vec3 relativePosition;
#endif
#ifdef EMISSION
flat in vec3 emission;
#endif

#ifndef FLAT_LIGHT
vec3 reflected() {
    Material material = materialAt(materialIndex);
    vec3 radiance = vec3(0.0);
#ifdef SUN
    radiance += lambert(sunIrradianceOn(faceNormal));
#endif
#ifdef AMBIENT_CONSTANT
    radiance += ambientRadiance;
#endif
    return radiance * material.baseColourRoughness.rgb;
}
#endif

void main() {
#ifdef FLAT_LIGHT
    vec3 radiance = reflectedPerAlbedo;
#else
    vec3 radiance = reflected();
#endif
#ifdef TEXTURED
    radiance *= texture(colours, vec3(st, colourLayer)).rgb;
#endif
#ifdef EMISSION
    radiance += emission;
#endif
    writeRadiance(radiance);
}
