// The portal gun before the eye, in front of all depths of the level. It is lit at its vertices: they are as dense as a
// picture's details, and a software rasteriser pays for each varying of each triangle.
#include "frame.glsl"

layout(location = 0) in vec3 position; // metres, in the gun's frame
layout(location = 1) in vec4 normalAndMaterial;

// The gun's axes and origin from the eye, as it is drawn.
uniform vec3 drawnRight;
uniform vec3 drawnUp;
uniform vec3 drawnBack;
uniform vec3 drawnPlace;

#ifndef ONLY_DEPTH
#define MOVING_RECEIVER
#include "displayed.glsl"
#include "materials.glsl"
#include "surface-light.glsl"
#include "gun-light.glsl"

out vec3 radiance;

// The gun's axes as it is lit.
uniform vec3 gunRight;
uniform vec3 gunUp;
uniform vec3 gunBack;
uniform vec3 lamp; // as displayed
uniform vec4 secondMark; // rgb: as lamp, a: 1 where it shines
uniform vec3 flash; // as lamp
#ifdef ANCHOR_POSITION
uniform vec3 eyeFromAnchor;
#endif
#ifdef SKY_AMBIENT
uniform vec3 skySeenAhead; // shares of the sky towards +x, +y and +z
uniform vec3 skySeenBehind;
#endif
#ifdef BOUNCED_LIGHT
uniform vec3 bounced[6]; // the radiance around +x, +y, +z, -x, -y and -z
#endif

const float LIGHT_SHARE = 0.35; // of the way to the gun where it is lit: within the player's body, which walls keep out

#ifdef BOUNCED_LIGHT
const float FILL = 0.0;

vec3 bouncedOn(vec3 n) {
    vec3 weights = n * n;
    return weights.x * bounced[n.x < 0.0 ? 3 : 0] + weights.y * bounced[n.y < 0.0 ? 4 : 1]
            + weights.z * bounced[n.z < 0.0 ? 5 : 2];
}
#else
// Light that surfaces around reflect to the gun's dark sides, as displayed.
const float FILL = 0.06;
#endif
const float OUTLINE = 0.012; // more of it at the outline, as of all surfaces seen at a slant

vec3 lampRadiance(vec4 shining, float facing) {
    vec3 hot = mix(shining.rgb, vec3(1.0), 0.03 * facing * facing);
    return radianceOf(mix(shining.rgb * 0.1, hot * (0.55 + 0.2 * facing), shining.a) + flash);
}

// own: the normal in the gun's frame
vec3 litRadiance(vec3 relative, vec3 own, vec3 n, vec3 toEye) {
    Material material = materialAt(normalAndMaterial.w);
    Surface s;
    s.baseColour = material.baseColourRoughness.rgb;
    s.faceNormal = n;
    s.normal = n;
#ifdef METALLIC_ROUGHNESS
    s.roughness = material.baseColourRoughness.a;
    s.toEye = toEye;
#endif
#if defined(METALLIC_ROUGHNESS) || defined(ALL_DIFFUSE)
    s.metallic = material.emissionMetallic.a;
#endif
#ifdef ANCHOR_POSITION
    s.anchorPosition = eyeFromAnchor + LIGHT_SHARE * relative;
#endif
#ifdef SKY_AMBIENT
    s.skyVisibility = dot(n * n, mix(skySeenBehind, skySeenAhead, step(0.0, n)));
#endif
#ifdef BOUNCED_LIGHT
    s.bounced = bouncedOn(n);
#ifdef METALLIC_ROUGHNESS
    s.bouncedMirrored = bouncedOn(reflect(-toEye, n));
#endif
#endif
    vec2 light = gunLight(position, own);
    vec3 glow = (0.15 + s.baseColour) * (lamp * light.x + flash * light.y);
    float aside = 1.0 - max(dot(n, toEye), 0.0);
    glow += s.baseColour * (FILL * (1.0 + 0.5 * n.y)) + OUTLINE * aside * aside * aside;
    return surfaceRadiance(s) + radianceOf(glow);
}
#endif

const float DEPTH_SHARE = 0.05;

void main() {
    vec3 relative = drawnPlace + drawnRight * position.x + drawnUp * position.y + drawnBack * position.z;
    gl_Position = clipFromRelative * vec4(relative, 1.0);
    gl_Position.z = (gl_Position.z + gl_Position.w) * DEPTH_SHARE - gl_Position.w;
#ifndef ONLY_DEPTH
    vec3 own = normalize(normalAndMaterial.xyz);
    vec3 n = gunRight * own.x + gunUp * own.y + gunBack * own.z;
    vec3 toEye = -normalize(relative);
    int material = int(normalAndMaterial.w + 0.5);
    radiance = material < FIRST_LAMP
            ? litRadiance(relative, own, n, toEye)
            : lampRadiance(material == FIRST_LAMP ? vec4(lamp, 1.0) : secondMark, max(dot(n, toEye), 0.0));
#endif
}
