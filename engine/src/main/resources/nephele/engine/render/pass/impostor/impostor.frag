// A plant from its atlas, lit as its mesh is.
#define MOVING_RECEIVER
#include "output.glsl"
#include "surface-light.glsl"
#include "plant-light.glsl"
#include "plant-threshold.glsl"
#include "impostor-texels.glsl"
#include "plants.glsl"

uniform vec3 eyeHigh;
uniform vec3 eyeLow;

in vec3 relativePosition;
flat in vec3 towardsEye;
flat in vec4 plantLook;
flat in vec2 plantTurn;
flat in vec4 skyFit;
flat in vec3 fromCentreToEye;
flat in vec3 emission;
flat in vec3 addedRadiance; // by air and fog
flat in float passing; // share of the light behind fog
#ifdef AIR
flat in vec3 airPassing;
#endif
#ifndef MULTISAMPLED
in vec2 onRectangle; // 0 to 1
flat in vec4 noiseCells; // along its sides, a random number, and the share of noise
#endif

#ifndef MULTISAMPLED
// Leaves that a texel does not resolve are drawn in as many pixels as they cover, chosen by noise that moves with the
// plant (Wyman and McGuire 2017, "Hashed Alpha Testing").
float hashedThreshold() {
    uvec2 cell = uvec2(onRectangle * noiseCells.xy);
    uint bits = cell.x * 1597334677u ^ cell.y * 3812015801u ^ uint(noiseCells.z);
    bits = (bits ^ (bits >> 16)) * 2246822519u;
    bits = (bits ^ (bits >> 13)) * 3266489917u;
    float noise = float(bits >> 8) * (1.0 / 16777216.0);
    return clamp(0.5 + noiseCells.w * (noise - 0.5), 0.02, 0.98);
}
#endif

// In radii: depths of leaves that a texel does not resolve are mixed.
const float LIFT = 0.15;

void main() {
    ImpostorTexel texel = impostorTexel(plantLook.w);
    float alpha = texel.colour.a;
#ifdef MULTISAMPLED
    float least = 0.0625;
#else
    float least = hashedThreshold();
#endif
    if (alpha < least || plantThreshold() < plantLook.y) {
        discard;
    }
    vec3 albedo = texel.colour.rgb / alpha;
    vec3 normal = turned(texel.normal / alpha, plantTurn);
    vec3 surface = relativePosition + towardsEye * (texel.depth * plantLook.x);
    vec3 inRadii = (surface + fromCentreToEye) / plantLook.x;
    float sky = skyFit.x + skyFit.y * inRadii.y + skyFit.z * inRadii.y * inRadii.y + skyFit.w * dot(inRadii.xz, inRadii.xz);
    vec3 radiance = plantRadiance(albedo, normal, surface + eyeHigh + eyeLow, LIFT * plantLook.x, plantLook.z * clamp(sky, 0.0, 1.0));
    radiance += emission;
#ifdef AIR
    radiance *= airPassing;
#endif
    writeRadiance(radiance * passing + addedRadiance);
#ifdef MULTISAMPLED
    pixel.a = alpha;
#endif
}
