#include "relative-position.glsl"
#include "materials.glsl"
// Each file is included once, so the one that both branches need comes first.
#ifdef BAKED_LIGHT
#include "baked-light.glsl"
#endif
#ifdef LIGHT_MAP
#include "light-map.glsl"
#endif
#ifdef FLAT_LIGHT
#include "surface-light.glsl"
#endif

layout(location = 1) in vec4 normalAndMaterial;
layout(location = 2) in vec2 textureCoordinates;
#ifdef LIGHT_MAP
layout(location = 3) in vec2 lightMapSixteenths;
#endif
#ifdef MODEL
layout(location = 3) in vec4 smoothNormalAndSky; // 32767 for 1
#endif

#if defined(TEXTURED) || defined(NORMAL_MAP)
out vec2 st;
flat out vec2 layers; // x: base colour, y: normal map
#endif
#ifdef FLAT_LIGHT
flat out vec3 reflectedPerAlbedo;
#else
flat out vec3 faceNormal;
flat out float materialIndex;
#endif
#if defined(METALLIC_ROUGHNESS) || defined(FOG) || defined(AIR) || (defined(NORMAL_MAP) && (defined(MODEL) || defined(TURNED_TEXTURE)))
out vec3 relativePosition;
#endif
#ifdef MODEL
out vec3 smoothNormal;
#ifdef SKY_AMBIENT
out float skyVisibility;
#endif
#ifdef BAKED_LIGHT
out vec3 bakedRadiance;
#ifdef BAKED_DIRECTION
out vec3 bakedDirection;
#endif
#ifdef BAKED_MIRRORED
out vec3 bakedMirrored;
#endif
#endif
#endif
#ifdef ANCHOR_POSITION
uniform vec3 cellFromAnchor; // the cell's origin, metres from the anchor
out vec3 anchorPosition;
#endif
#ifdef LIGHT_MAP
out vec2 lightMapPosition;
#endif
#ifdef EMISSION
flat out vec3 emission;
#endif

void main() {
    vec3 relative = placeVertex();
    vec3 normal = normalize(normalAndMaterial.xyz);
    Material material = materialAt(normalAndMaterial.w);
#if defined(TEXTURED) || defined(NORMAL_MAP)
    st = textureCoordinates;
    layers = material.layers.xy;
#endif
#ifdef EMISSION
    emission = material.emissionMetallic.rgb;
#endif
#ifdef FLAT_LIGHT
    // A flat face under parallel light has the same light everywhere, so once per corner is exact.
    reflectedPerAlbedo = surfaceRadiance(Surface(material.baseColourRoughness.rgb, normal, normal));
#else
    faceNormal = normal;
    materialIndex = normalAndMaterial.w;
#endif
#if defined(METALLIC_ROUGHNESS) || defined(FOG) || defined(AIR) || (defined(NORMAL_MAP) && (defined(MODEL) || defined(TURNED_TEXTURE)))
    relativePosition = relative;
#endif
#ifdef MODEL
    smoothNormal = smoothNormalAndSky.xyz / 32767.0;
#ifdef SKY_AMBIENT
    skyVisibility = smoothNormalAndSky.w / 32767.0;
#endif
#ifdef BAKED_LIGHT
    BakedLight baked = bakedLightOfVertex(gl_VertexID);
    bakedRadiance = baked.radiance;
#ifdef BAKED_DIRECTION
    bakedDirection = baked.direction;
#endif
#ifdef BAKED_MIRRORED
    bakedMirrored = baked.mirrored;
#endif
#endif
#endif
#ifdef ANCHOR_POSITION
    anchorPosition = position + cellFromAnchor;
#endif
#ifdef LIGHT_MAP
    lightMapPosition = lightMapCoordinates(lightMapSixteenths);
#endif
}
