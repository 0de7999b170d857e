// A plant's mesh, matt.
#define MOVING_RECEIVER
#include "output.glsl"
#include "surface-light.glsl"
#include "plant-light.glsl"
#include "plant-threshold.glsl"

uniform vec3 eyeHigh;
uniform vec3 eyeLow;
uniform vec4 baseColour; // a: light of the lobe that impostors reflect diffusely
#ifdef TEXTURED
uniform sampler2DArray colours;
uniform float pictureLayer;
in vec2 st;
#endif

in vec3 relativePosition;
in vec3 normal;
in float skyShare;
flat in vec2 plantLook;
flat in vec3 emission;

const float LIFT = 0.05; // in radii

void main() {
    if (plantThreshold() >= plantLook.y) {
        discard;
    }
    vec3 albedo = baseColour.rgb;
#ifdef TEXTURED
    albedo *= texture(colours, vec3(st, pictureLayer)).rgb;
#endif
    albedo += (1.0 - albedo) * baseColour.a;
    vec3 radiance = plantRadiance(albedo, normalize(normal), relativePosition + eyeHigh + eyeLow, LIFT * plantLook.x, skyShare);
    radiance += emission;
#if defined(FOG) || defined(AIR)
    writeRadiance(radiance, relativePosition);
#else
    writeRadiance(radiance);
#endif
}
