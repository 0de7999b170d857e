// Radiance that a surface sends to the eye; numbers and textures come from render.resource.SurfaceLight. The level's light
// decides what is compiled: METALLIC_ROUGHNESS (else Lambert; ALL_DIFFUSE: with the light of the omitted lobe), SUN, SUN_SHADOW, DYNAMIC_SUN_SHADOW,
// DYNAMIC_LIGHT_SHADOW, CONTACT (moving objects darken ambient light), CLOUD_SHADE, PUNCTUAL_LIGHTS, LIGHT_SHADOW, AMBIENT_CONSTANT, SKY_AMBIENT, FLASH; SKY_VISIBILITY with it on static
// faces; BAKED_LIGHT: light of baked-light.glsl in addition; SKY_BAKED: that of the sky is in it, and only lightning asks for its visibility; BOUNCED_LIGHT: light of other surfaces on moving things and billboards; LIGHT_PARTS: only the parts of light that lightParts names. CURVED_RECEIVER: triangles that approximate a curved surface, whose planes no depth map resolves, are shaded
// as dynamic objects are. NEAREST_SHADOW: one texel of a depth map decides, not four. ANCHOR_POSITION goes with each of SUN_SHADOW, CONTACT, CLOUD_SHADE, DYNAMIC_SUN_SHADOW, PUNCTUAL_LIGHTS and FLASH.

#ifdef BAKED_LIGHT
#include "baked-light.glsl"
#endif
#if defined(SKY_AMBIENT) && !defined(SKY_BAKED)
#define SKY_LIGHT
#endif
#if defined(AMBIENT_CONSTANT) || defined(SKY_LIGHT) || defined(BAKED_LIGHT) || defined(BOUNCED_LIGHT)
#define AMBIENT
#endif

struct Surface {
    vec3 baseColour;
    vec3 normal;  // unit, with the normal map
    vec3 faceNormal;  // unit, of the geometry
#ifdef MODEL
    vec3 smoothNormal;  // unit, of the curved surface
#endif
#ifdef METALLIC_ROUGHNESS
    float roughness;
    vec3 toEye;  // unit
#endif
#if defined(METALLIC_ROUGHNESS) || defined(ALL_DIFFUSE)
    float metallic;
#endif
#ifdef ANCHOR_POSITION
    vec3 anchorPosition;  // metres from the anchor of the level's light
#endif
#ifdef SKY_AMBIENT
    float skyVisibility;  // 0 to 1
#endif
#ifdef BAKED_LIGHT
    BakedLight baked;
#endif
#if defined(CONTACT) && defined(MOVING_RECEIVER)
    int instance;
#endif
#ifdef BOUNCED_LIGHT
    vec3 bounced;  // radiance of a white surface that only other surfaces light
#ifdef METALLIC_ROUGHNESS
    vec3 bouncedMirrored;  // the same, facing the mirrored direction
#endif
#endif
};

#ifdef METALLIC_ROUGHNESS
#include "brdf.glsl"
#else
const float PI = 3.14159265;
#endif

#if defined(SUN) || defined(PUNCTUAL_LIGHTS) || defined(AMBIENT) || defined(FLASH)
#include "light.glsl"
#endif
#if defined(SUN_SHADOW) || defined(LIGHT_SHADOW) || defined(DYNAMIC_SUN_SHADOW)
#include "shadow-filter.glsl"
#endif
#if defined(DYNAMIC_SUN_SHADOW) || defined(DYNAMIC_LIGHT_SHADOW)
#include "dynamic-shadows.glsl"
#endif
#ifdef CONTACT
#include "contact.glsl"
#endif
#ifdef SUN_SHADOW
#include "sun-shadow.glsl"
#endif
#ifdef CLOUD_SHADE
#include "cloud-shade.glsl"
#endif
#ifdef PUNCTUAL_LIGHTS
#include "light-falloff.glsl"
#include "punctual-lights.glsl"
#endif
#ifdef LIGHT_SHADOW
#include "light-shadow.glsl"
#endif
#ifdef SKY_LIGHT
#include "sky-ambient.glsl"
#endif
#ifdef LIGHT_MAP
#include "light-map.glsl"
#endif

// The largest finite half float: lights may be arbitrarily near and strong, but targets must not overflow.
const float MAX_RADIANCE = java(level.appearance.LuminanceHistogram.LARGEST_HALF);

#ifdef METALLIC_ROUGHNESS
#define REFLECTANCE Brdf
Brdf reflectanceOf(Surface s) {
    return brdfOf(s.baseColour, s.roughness, s.metallic, dot(s.normal, s.toEye));
}
#ifdef LIGHT_PARTS
Brdf shown(Brdf b) {
    b.diffuse *= lightParts.y;
    b.specularGain *= lightParts.z;
    return b;
}
#endif
vec3 reflected(Brdf b, Surface s, vec3 toLight) {
    return reflectedLight(b, s.normal, s.toEye, toLight);
}
#else
#define REFLECTANCE vec3
vec3 reflectanceOf(Surface s) {
#ifdef ALL_DIFFUSE
    // An insulator's specular lobe returns 5 % of equal light from all directions at roughness 0.6 (9 % at 0.1, 2 % at 1).
    return s.baseColour + (1.0 - s.baseColour) * (0.05 - 0.05 * s.metallic);
#else
    return s.baseColour;
#endif
}
#ifdef LIGHT_PARTS
vec3 shown(vec3 albedo) {
    return albedo * lightParts.y;
}
#endif
vec3 reflected(vec3 albedo, Surface s, vec3 toLight) {
    return albedo * (max(dot(s.normal, toLight), 0.0) * (1.0 / PI));
}
#endif

#if defined(MODEL) && (defined(SUN) || defined(PUNCTUAL_LIGHTS))
// Fades light where a triangle, but not yet its curved surface, faces away from it; otherwise light would end along the
// triangle's edges (Chiang, Li and Burley 2019, "Taming the Shadow Terminator"). Twin: reference.SurfacePoint#terminator.
float terminatorShare(Surface s, vec3 toLight) {
    float onCurve = dot(s.smoothNormal, toLight) * dot(s.faceNormal, s.smoothNormal);
    float g = onCurve > 0.0 ? min(dot(s.faceNormal, toLight) / onCurve, 1.0) : 1.0;
    return g * (1.0 + g - g * g);
}
#endif

#ifdef CURVED_RECEIVER
// Under grazing light, a triangle's plane extrapolated to the next texel's centre is behind its occluder; this gives up
// a few hundredths of the light to hide that.
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
#ifdef CLOUD_SHADE
    lit *= cloudLitShare(s.anchorPosition);
#endif
#ifdef DYNAMIC_SUN_SHADOW
    if (lit > 0.0) {
        lit *= dynamicSunLitShare(s.anchorPosition, s.faceNormal, nDotSun);
    }
#endif
    return reflected(r, s, sunDirection) * sunIrradiance * lit;
}
#endif

#ifdef PUNCTUAL_LIGHTS
vec3 punctualLighting(REFLECTANCE r, Surface s, int index) {
    PunctualLight punctualLight = lightAt(index);
    vec3 fromLight = s.anchorPosition - punctualLight.position.xyz;
    float squareDistance = dot(fromLight, fromLight);
    vec3 towardsLight = fromLight * -inversesqrt(max(squareDistance, 1e-12));
    float lit = dot(s.faceNormal, towardsLight) > 0.0 ? 1.0 : 0.0;
#ifdef MODEL
    lit *= terminatorShare(s, towardsLight);
#endif
#ifdef LIGHT_SHADOW
    if (punctualLight.shadow.w >= 0.0) {
#ifdef CURVED_RECEIVER
        lit *= steepShare(dot(s.faceNormal, towardsLight));
#endif
        lit *= lightLitShare(punctualLight, fromLight, s.faceNormal);
    }
#endif
    return reflected(r, s, towardsLight) * lightIrradiance(punctualLight, towardsLight, squareDistance) * lit;
}

vec3 allLights(REFLECTANCE r, Surface s) {
    vec3 sum = vec3(0.0);
    ivec2 list = lightListAt(s.anchorPosition, s.faceNormal);
    for (int entry = list.x; entry < list.y; entry++) {
        sum += punctualLighting(r, s, lightOfEntry(entry));
    }
    return sum;
}
#endif

#if defined(BAKED_LIGHT) || defined(CONTACT)
// Returns the normal without a normal map, for which light is baked.
vec3 ownNormal(Surface s) {
#ifdef MODEL
    return s.smoothNormal;
#else
    return s.faceNormal;
#endif
}
#endif

// Ambient light. A rough approximation of reflection: the irradiance in the mirrored direction, which is right
// for matt metal and too blurred for polished metal.
#ifdef AMBIENT
vec3 ambientLight(REFLECTANCE r, Surface s) {
#ifdef AMBIENT_CONSTANT
    vec3 diffuse = ambientRadiance;
    vec3 mirrored = ambientRadiance;
#elif defined(SKY_LIGHT)
    vec3 diffuse = skyAmbient(s.normal) * s.skyVisibility;
#ifdef METALLIC_ROUGHNESS
    vec3 mirrored = skyAmbient(reflect(-s.toEye, s.normal)) * s.skyVisibility;
#endif
#else
    vec3 diffuse = vec3(0.0);
    vec3 mirrored = vec3(0.0);
#endif
#ifdef BAKED_LIGHT
    diffuse += s.baked.radiance * gainFacing(s.baked, s.normal, ownNormal(s));
#ifdef METALLIC_ROUGHNESS
#ifdef BAKED_MIRRORED
    vec3 toMirror = s.baked.mirrored;
#else
    vec3 toMirror = s.baked.radiance;
#endif
    mirrored += toMirror * gainMirrored(s.baked, reflect(-s.toEye, s.normal), ownNormal(s));
#endif
#endif
#ifdef BOUNCED_LIGHT
    diffuse += s.bounced;
#ifdef METALLIC_ROUGHNESS
    mirrored += s.bouncedMirrored;
#endif
#endif
#ifdef METALLIC_ROUGHNESS
    vec3 ambient = r.diffuse * diffuse + r.ambientSpecular * mirrored;
#else
    vec3 ambient = r * diffuse;
#endif
#ifdef LIGHT_PARTS
    ambient *= lightParts.x;
#endif
    return ambient;
}
#endif

#ifdef CONTACT
// Returns the share of ambient light that moving objects do not hide.
float contactShare(Surface s) {
#ifdef MOVING_RECEIVER
    return contactOpenShare(s.anchorPosition, s.faceNormal, s.instance);
#else
    return contactOpenShare(s.anchorPosition, ownNormal(s), -1);
#endif
}
#endif

#ifdef FLASH
#include "flash-light.glsl"
#endif

vec3 surfaceRadiance(Surface s) {
    REFLECTANCE r = reflectanceOf(s);
    vec3 sum = vec3(0.0);
#ifdef AMBIENT
    sum += ambientLight(r, s);
#ifdef CONTACT
    sum *= contactShare(s);
#endif
#endif
#ifdef LIGHT_PARTS
    r = shown(r);
#endif
#ifdef SUN
    sum += sunLight(r, s);
#endif
#ifdef PUNCTUAL_LIGHTS
    sum += allLights(r, s);
#endif
#ifdef FLASH
    sum += flashLight(r, s);
#endif
    return min(sum, vec3(MAX_RADIANCE));
}
