#include "output.glsl"
#include "materials.glsl"
#ifndef FLAT_LIGHT
#include "surface-light.glsl"
#endif
#include "covered-position.glsl"
#ifdef NORMAL_MAP
#include "face-texture.glsl"
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
#if defined(METALLIC_ROUGHNESS) || defined(FOG) || defined(AIR) || (defined(NORMAL_MAP) && (defined(MODEL) || defined(TURNED_TEXTURE)))
in vec3 relativePosition;
#endif
#ifdef MODEL
in vec3 smoothNormal;
#ifdef SKY_AMBIENT
in float skyVisibility;
#endif
#ifdef BAKED_LIGHT
in vec3 bakedRadiance;
#ifdef BAKED_DIRECTION
in vec3 bakedDirection;
#endif
#ifdef BAKED_MIRRORED
in vec3 bakedMirrored;
#endif
#endif
#endif
#ifdef ANCHOR_POSITION
in vec3 anchorPosition;
#endif
#ifdef LIGHT_MAP
in vec2 lightMapPosition;
#endif
#ifdef EMISSION
flat in vec3 emission;
#endif

#ifdef NORMAL_MAP
#if defined(MODEL) || defined(TURNED_TEXTURE)
// Returns a direction projected onto the surface; another one if it has no projection.
vec3 along(vec3 direction, vec3 n, vec3 otherwise) {
    vec3 tangent = direction - n * dot(n, direction);
    float square = dot(tangent, tangent);
    return square > 0.0 ? tangent * inversesqrt(square) : otherwise;
}

// Uses the mapping of a mesh or of a picture turned on a face, where the texture coordinates grow (Schueler 2013,
// "Normal Mapping without Precomputed Tangents"). Twins: nephele.engine.reference.TriangleMeshShape and
// nephele.engine.level.appearance.FaceTexture.
vec3 growthMappedNormal(vec3 texel, vec3 n) {
    vec3 right = cross(dFdy(relativePosition), faceNormal);
    vec3 above = cross(faceNormal, dFdx(relativePosition));
#ifdef MIRRORS
    // In a mirrored view the picture's x and y have the opposite orientation about the normal.
    right *= viewForward.w;
    above *= viewForward.w;
#endif
    vec2 rightwards = dFdx(st);
    vec2 upwards = dFdy(st);
    vec3 across = along(right * rightwards.x + above * upwards.x, n, textureAcross(n));
    vec3 up = along(-(right * rightwards.y + above * upwards.y), n, cross(n, across));
    return mappedNormal(texel, n, across, up);
}
#endif
#endif

#ifndef FLAT_LIGHT
vec3 litRadiance(vec3 texel) {
    vec2 offset = coveredOffset();
    Material material = materialAt(materialIndex);
    Surface s;
    s.baseColour = material.baseColourRoughness.rgb * texel;
    s.faceNormal = faceNormal;
#ifdef MODEL
    s.smoothNormal = normalize(smoothNormal);
    s.normal = s.smoothNormal;
#else
    s.normal = faceNormal;
#endif
    float roughness = material.baseColourRoughness.a;
#ifdef NORMAL_MAP
    vec4 detail = detailed(normals, vec3(st, layers.y));
#if defined(MODEL) || defined(TURNED_TEXTURE)
    s.normal = growthMappedNormal(detail.rgb, s.normal);
#else
    vec3 across = textureAcross(faceNormal);
    s.normal = mappedNormal(detail.rgb, faceNormal, across, cross(faceNormal, across));
#endif
    roughness *= detail.a;
#endif
#ifdef METALLIC_ROUGHNESS
    s.roughness = roughness;
    s.toEye = -normalize(relativePosition);
#endif
#if defined(METALLIC_ROUGHNESS) || defined(ALL_DIFFUSE)
    s.metallic = material.emissionMetallic.a;
#endif
#ifdef ANCHOR_POSITION
    s.anchorPosition = atCovered(anchorPosition, offset);
#endif
#ifdef LIGHT_MAP
    vec2 onMap = atCovered(vec3(lightMapPosition, 0.0), offset).xy;
#ifdef BAKED_LIGHT
    s.baked = bakedLightAt(onMap);
#endif
#elif defined(BAKED_LIGHT)
    s.baked.radiance = bakedRadiance;
#ifdef BAKED_DIRECTION
    s.baked.direction = bakedDirection;
#endif
#ifdef BAKED_MIRRORED
    s.baked.mirrored = bakedMirrored;
#endif
#endif
#ifdef SKY_VISIBILITY
    s.skyVisibility = skyVisibilityAt(onMap);
#elif defined(SKY_AMBIENT)
    s.skyVisibility = skyVisibility;
#endif
    return surfaceRadiance(s);
}
#endif

void main() {
    vec3 texel = vec3(1.0);
#ifdef TEXTURED
    texel = detailed(colours, vec3(st, layers.x)).rgb;
#endif
#ifdef FLAT_LIGHT
    vec3 radiance = reflectedPerAlbedo * texel;
#else
    vec3 radiance = litRadiance(texel);
#endif
#ifdef EMISSION
    radiance += emission;
#endif
#if defined(FOG) || defined(AIR)
    writeRadiance(radiance, relativePosition);
#else
    writeRadiance(radiance);
#endif
}
