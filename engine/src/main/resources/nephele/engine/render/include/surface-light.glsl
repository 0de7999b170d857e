// Radiance that a surface sends to the eye; numbers and textures come from render.frame.SurfaceLight. What is compiled is what the level asks for:
//   METALLIC_ROUGHNESS (else Lambert), SUN, SUN_SHADOW, THING_SUN_SHADOW, THING_LAMP_SHADOW, LAMPS, LAMP_SHADOW, AMBIENT_CONSTANT, SKY_AMBIENT; SKY_VISIBILITY with it on static faces.
// CURVED_RECEIVER: triangles that stand for a curve, whose planes no depth map resolves, are shaded as what moves is.
// ANCHOR_POSITION goes with each of SUN_SHADOW, THING_SUN_SHADOW and LAMPS.

struct Surface {
    vec3 baseColour;
    vec3 normal;  // unit, bent by the normal map
    vec3 faceNormal;  // unit, of the geometry
#ifdef MODEL
    vec3 smoothNormal;  // unit, of the surface that the triangle stands for
#endif
#ifdef METALLIC_ROUGHNESS
    float roughness;
    float metallic;
    vec3 toEye;  // unit
#endif
#ifdef ANCHOR_POSITION
    vec3 anchorPosition;  // metres from the anchor of the level's light
#endif
#ifdef SKY_AMBIENT
    float skyVisibility;  // 0 to 1
#endif
};

#ifdef METALLIC_ROUGHNESS
#include "brdf.glsl"
#else
const float PI = 3.14159265;
#endif

#if defined(SUN) || defined(LAMPS) || defined(AMBIENT_CONSTANT) || defined(SKY_AMBIENT)
#include "light.glsl"
#endif
#if defined(SUN_SHADOW) || defined(LAMP_SHADOW) || defined(THING_SUN_SHADOW)
#include "shadow-filter.glsl"
#endif
#if defined(THING_SUN_SHADOW) || defined(THING_LAMP_SHADOW)
#include "thing-shade.glsl"
#endif
#ifdef SUN_SHADOW
#include "sun-shadow.glsl"
#endif
#ifdef LAMPS
#include "lamp-falloff.glsl"
#include "lamps.glsl"
#endif
#ifdef LAMP_SHADOW
#include "lamp-shadow.glsl"
#endif
#ifdef SKY_AMBIENT
#include "sky-ambient.glsl"
#endif
#ifdef SKY_VISIBILITY
#include "sky-visibility.glsl"
#endif

// The largest finite half float: lights may be arbitrarily near and strong, targets may not overflow.
const float MAX_RADIANCE = 65504.0;

#ifdef METALLIC_ROUGHNESS
#define REFLECTANCE Brdf
Brdf reflectanceOf(Surface s) {
    return brdfOf(s.baseColour, s.roughness, s.metallic, dot(s.normal, s.toEye));
}
vec3 reflected(Brdf b, Surface s, vec3 toLight) {
    return reflectedLight(b, s.normal, s.toEye, toLight);
}
#else
#define REFLECTANCE vec3
vec3 reflectanceOf(Surface s) {
    return s.baseColour;
}
vec3 reflected(vec3 albedo, Surface s, vec3 toLight) {
    return albedo * (max(dot(s.normal, toLight), 0.0) * (1.0 / PI));
}
#endif

#if defined(MODEL) && (defined(SUN) || defined(LAMPS))
// Where a triangle turns away from the light the curve does not yet, and light would end along its edges: it fades
// instead (Chiang, Li and Burley 2019, "Taming the Shadow Terminator"). Twin: level.appearance.Terminator.
float terminatorShare(Surface s, vec3 toLight) {
    float onCurve = dot(s.smoothNormal, toLight) * dot(s.faceNormal, s.smoothNormal);
    float g = onCurve > 0.0 ? min(dot(s.faceNormal, toLight) / onCurve, 1.0) : 1.0;
    return g * (1.0 + g - g * g);
}
#endif

#ifdef CURVED_RECEIVER
// Under light that grazes it a triangle's plane, continued to the next texel's middle, comes out of the far side of what
// shades it: a few hundredths of the light are given up to that.
float steepShare(float cosine) {
    return clamp(cosine * 40.0 - 1.0, 0.0, 1.0);
}
#endif

#ifdef SUN
vec3 sunLight(REFLECTANCE r, Surface s) {
    float nDotSun = dot(s.faceNormal, sunDirection);
    float lit = nDotSun > 0.0 ? 1.0 : 0.0;
#ifdef MODEL
    lit *= terminatorShare(s, sunDirection);
#endif
#if defined(SUN_SHADOW) && defined(CURVED_RECEIVER)
    lit *= steepShare(nDotSun);
#endif
#ifdef SUN_SHADOW
    lit *= sunLitShare(s.anchorPosition, s.faceNormal, nDotSun);
#endif
#ifdef THING_SUN_SHADOW
    if (lit > 0.0) {
        lit *= thingSunLitShare(s.anchorPosition, s.faceNormal, nDotSun);
    }
#endif
    return reflected(r, s, sunDirection) * sunIrradiance * lit;
}
#endif

#ifdef LAMPS
vec3 lampLight(REFLECTANCE r, Surface s, int index) {
    Lamp lamp = lampAt(index);
    vec3 fromLamp = s.anchorPosition - lamp.position.xyz;
    float squareDistance = dot(fromLamp, fromLamp);
    vec3 toLamp = fromLamp * -inversesqrt(max(squareDistance, 1e-12));
    float lit = dot(s.faceNormal, toLamp) > 0.0 ? 1.0 : 0.0;
#ifdef MODEL
    lit *= terminatorShare(s, toLamp);
#endif
#ifdef LAMP_SHADOW
    if (lamp.shadow.w >= 0.0) {
#ifdef CURVED_RECEIVER
        lit *= steepShare(dot(s.faceNormal, toLamp));
#endif
        lit *= lampLitShare(lamp, fromLamp, s.faceNormal);
    }
#endif
    return reflected(r, s, toLamp) * lampIrradiance(lamp, toLamp, squareDistance) * lit;
}

vec3 allLamps(REFLECTANCE r, Surface s) {
    vec3 sum = vec3(0.0);
    ivec2 list = lampListAt(s.anchorPosition, s.faceNormal);
    for (int entry = list.x; entry < list.y; entry++) {
        sum += lampLight(r, s, lampOfEntry(entry));
    }
    return sum;
}
#endif

// Light from all around. A rough stand-in mirrors the sky: its irradiance in the mirrored direction, which is right for
// matt metal and too blurred for polished metal.
#if defined(AMBIENT_CONSTANT) || defined(SKY_AMBIENT)
vec3 ambientLight(REFLECTANCE r, Surface s) {
#ifdef AMBIENT_CONSTANT
    vec3 diffuse = ambientRadiance;
    vec3 mirrored = ambientRadiance;
#else
    vec3 diffuse = skyAmbient(s.normal) * s.skyVisibility;
#ifdef METALLIC_ROUGHNESS
    vec3 mirrored = skyAmbient(reflect(-s.toEye, s.normal)) * s.skyVisibility;
#endif
#endif
#ifdef METALLIC_ROUGHNESS
    return r.diffuse * diffuse + r.ambientSpecular * mirrored;
#else
    return r * diffuse;
#endif
}
#endif

vec3 surfaceRadiance(Surface s) {
    REFLECTANCE r = reflectanceOf(s);
    vec3 sum = vec3(0.0);
#ifdef SUN
    sum += sunLight(r, s);
#endif
#ifdef LAMPS
    sum += allLamps(r, s);
#endif
#if defined(AMBIENT_CONSTANT) || defined(SKY_AMBIENT)
    sum += ambientLight(r, s);
#endif
    return min(sum, vec3(MAX_RADIANCE));
}
