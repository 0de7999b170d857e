#define MOVING_RECEIVER
#include "output.glsl"
#include "materials.glsl"
#include "surface-light.glsl"
#include "covered-position.glsl"
#include "dynamic-instance.glsl"
#ifdef NORMAL_MAP
#include "normal-map.glsl"
uniform sampler2DArray normals;
#endif
#ifdef TEXTURED
uniform sampler2DArray colours;
#endif
#if defined(TEXTURED) || defined(NORMAL_MAP)
#include "face-texture.glsl"
#endif
#ifdef DETAIL
#include "dynamic-detail.glsl"
#endif
#ifdef SEE_THROUGH
#include "held-look.glsl"
uniform float clarity;
#endif

flat in int instance;
flat in float materialIndex;
in vec3 inPart;
in vec3 normalInPart;
in vec3 relativePosition;
in vec3 anchorPosition;
#if defined(TEXTURED) || defined(NORMAL_MAP)
in vec2 onSurface;
#endif

#if defined(TEXTURED) || defined(NORMAL_MAP)
const float TURN = 6.28318531;

// As in the reference path tracer (reference.BodySurfaces, the twin): t grows downwards. A box has the texture's middle
// in the middle of each face; a round shape has a whole number of repeats around it, with its equator or the middle of
// its side half-way up. As on solids, t falls upwards.
vec2 textureAt(int kind, vec3 n, vec4 size, float textureMetres) {
    if (kind == 0) {
        vec3 across = textureAcross(n);
        return vec2(dot(inPart, across), -dot(inPart, cross(n, across))) / textureMetres + 0.5;
    }
    float around = max(1.0, floor(TURN * size.x / textureMetres + 0.5));
    float up = (onSurface.y - 0.5) * TURN * size.x + clamp(inPart.y, -size.w, size.w);
    return vec2(onSurface.x * around, 0.5 - up / textureMetres);
}
#endif

void main() {
    Material material = materialAt(materialIndex);
    vec4 turn = instanceTexel(instance, 0);
    vec4 size = instanceTexel(instance, 3);
    vec3 n = normalize(normalInPart);
    Surface s;
    s.baseColour = material.baseColourRoughness.rgb;
    float roughness = material.baseColourRoughness.a;
    s.faceNormal = turned(turn, n);
    s.normal = s.faceNormal;
#if defined(TEXTURED) || defined(NORMAL_MAP)
    vec2 st = textureAt(int(instanceTexel(instance, 2).w), n, size, material.layers.z);
#endif
#ifdef TEXTURED
    s.baseColour *= detailed(colours, vec3(st, material.layers.x)).rgb;
#endif
#ifdef NORMAL_MAP
    vec4 bumps = detailed(normals, vec3(st, material.layers.y));
    vec3 across = textureAcross(n);
    s.normal = turned(turn, mappedNormal(bumps.rgb, n, across, cross(n, across)));
    roughness *= bumps.a;
#endif
#ifdef DETAIL
    vec4 detailed = detail(int(instanceTexel(instance, 2).w), inPart, n, size);
    s.normal = turned(turn, detailed.xyz);
    s.baseColour *= detailed.w;
#endif
#ifdef METALLIC_ROUGHNESS
    s.roughness = roughness;
    s.toEye = -normalize(relativePosition);
#endif
#if defined(METALLIC_ROUGHNESS) || defined(ALL_DIFFUSE)
    s.metallic = material.emissionMetallic.a;
#endif
#ifdef ANCHOR_POSITION
    s.anchorPosition = atCovered(anchorPosition, coveredOffset());
#endif
#ifdef SKY_AMBIENT
    s.skyVisibility = skySeen(instance, s.normal);
#endif
#ifdef CONTACT
    s.instance = instance;
#endif
#ifdef BOUNCED_LIGHT
    s.bounced = bouncedOn(instance, s.normal);
#ifdef METALLIC_ROUGHNESS
    s.bouncedMirrored = bouncedOn(instance, reflect(-s.toEye, s.normal));
#endif
#endif
    writeRadiance(surfaceRadiance(s) + material.emissionMetallic.rgb, relativePosition);
#ifdef DISTANCE_STORED
    pixel.a = -gl_FragCoord.w; // it may move
#endif
#ifdef SEE_THROUGH
    float towardsEye = dot(s.faceNormal, -normalize(relativePosition));
    float opacity = heldOpacity(int(instanceTexel(instance, 2).w), inPart, n, size.xyz, towardsEye);
    pixel.a = mix(1.0, opacity, clarity);
#endif
}
