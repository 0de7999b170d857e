#include "output.glsl"
#include "materials.glsl"
#ifndef FLAT_LIGHT
#include "surface-light.glsl"
#endif
#ifdef NORMAL_MAP
#include "normal-map.glsl"
uniform sampler2DArray normals;
#endif
#ifdef TEXTURED
uniform sampler2DArray colours;
#endif

#if defined(TEXTURED) || defined(NORMAL_MAP)
in vec2 st;
flat in vec2 layers;
#endif
#ifdef FLAT_LIGHT
flat in vec3 reflectedPerAlbedo;
#else
flat in vec3 faceNormal;
flat in float materialIndex;
#endif
#if defined(METALLIC_ROUGHNESS) || defined(FOG)
in vec3 relativePosition;
#endif
#ifdef ANCHOR_POSITION
in vec3 anchorPosition;
#endif
#ifdef SKY_VISIBILITY
in vec2 lightMapPosition;
#endif
#ifdef EMISSION
flat in vec3 emission;
#endif

#ifdef NORMAL_MAP
// The directions of the texture on a face, as level.appearance.FaceTexture defines them.
vec3 textureAcross(vec3 n) {
    return normalize(abs(n.y) > 0.999 ? vec3(1.0, 0.0, 0.0) - n * n.x : cross(vec3(0.0, 1.0, 0.0), n));
}
#endif

#ifndef FLAT_LIGHT
vec3 litRadiance(vec3 texel) {
    Material material = materialAt(materialIndex);
    Surface s;
    s.baseColour = material.baseColourRoughness.rgb * texel;
    s.faceNormal = faceNormal;
    s.normal = faceNormal;
    float roughness = material.baseColourRoughness.a;
#ifdef NORMAL_MAP
    vec4 detail = texture(normals, vec3(st, layers.y));
    vec3 across = textureAcross(faceNormal);
    s.normal = mappedNormal(detail.rgb, faceNormal, across, cross(faceNormal, across));
    roughness *= detail.a;
#endif
#ifdef METALLIC_ROUGHNESS
    s.roughness = roughness;
    s.metallic = material.emissionMetallic.a;
    s.toEye = -normalize(relativePosition);
#endif
#ifdef ANCHOR_POSITION
    s.anchorPosition = anchorPosition;
#endif
#ifdef SKY_VISIBILITY
    s.skyVisibility = skyVisibilityAt(lightMapPosition);
#endif
    return surfaceRadiance(s);
}
#endif

void main() {
    vec3 texel = vec3(1.0);
#ifdef TEXTURED
    texel = texture(colours, vec3(st, layers.x)).rgb;
#endif
#ifdef FLAT_LIGHT
    vec3 radiance = reflectedPerAlbedo * texel;
#else
    vec3 radiance = litRadiance(texel);
#endif
#ifdef EMISSION
    radiance += emission;
#endif
#ifdef FOG
    writeRadiance(radiance, relativePosition);
#else
    writeRadiance(radiance);
#endif
}
