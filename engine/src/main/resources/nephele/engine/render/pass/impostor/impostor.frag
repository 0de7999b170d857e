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

void main() {
    ImpostorTexel texel = impostorTexel(plantLook.w);
    float alpha = texel.colour.a;
#ifdef MULTISAMPLED
    float covered = clamp((alpha - 0.5) / max(fwidth(alpha), 1e-4) + 0.5, 0.0, 1.0);
    bool isSeen = covered > 0.0;
#else
    bool isSeen = alpha >= 0.5;
#endif
    if (!isSeen || plantThreshold() < plantLook.y) {
        discard;
    }
    vec3 albedo = texel.colour.rgb / alpha;
    vec3 normal = turned(texel.normal / alpha, plantTurn);
    vec3 surface = relativePosition + towardsEye * (texel.depth * plantLook.x);
    vec3 inRadii = (surface + fromCentreToEye) / plantLook.x;
    float sky = skyFit.x + skyFit.y * inRadii.y + skyFit.z * inRadii.y * inRadii.y + skyFit.w * dot(inRadii.xz, inRadii.xz);
    vec3 radiance = plantRadiance(albedo, normal, surface + eyeHigh + eyeLow, plantLook.x, plantLook.z * clamp(sky, 0.0, 1.0));
    radiance += emission;
#if defined(FOG) || defined(AIR)
    writeRadiance(radiance, surface);
#else
    writeRadiance(radiance);
#endif
#ifdef MULTISAMPLED
    pixel.a = covered;
#endif
}
