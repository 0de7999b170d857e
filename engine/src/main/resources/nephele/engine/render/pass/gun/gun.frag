#define MOVING_RECEIVER
#include "output.glsl"
#include "displayed.glsl"
#include "materials.glsl"
#include "surface-light.glsl"
#include "gun-light.glsl"

flat in float materialIndex;
in vec3 inGun; // few varyings: a software rasteriser prepares each for each triangle
in vec3 normalInGun;

// The gun's axes and origin from the eye: as it is drawn, and as it is lit.
uniform vec3 drawnRight;
uniform vec3 drawnUp;
uniform vec3 drawnBack;
uniform vec3 drawnPlace;
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

const float LIGHT_SHARE = 0.35; // of the way to the gun where it is lit: within the player's body, which walls keep out

// Light that surfaces around reflect to the gun's dark sides, as displayed.
const float FILL = 0.06;
const float OUTLINE = 0.012; // more of it at the outline, as of all surfaces seen at a slant

void main() {
    vec3 own = normalize(normalInGun);
    vec3 n = gunRight * own.x + gunUp * own.y + gunBack * own.z;
    vec3 relativePosition = drawnPlace + drawnRight * inGun.x + drawnUp * inGun.y + drawnBack * inGun.z;
    vec3 toEye = -normalize(relativePosition);
    int index = int(materialIndex + 0.5);
    if (index >= FIRST_LAMP) {
        vec4 shining = index == FIRST_LAMP ? vec4(lamp, 1.0) : secondMark;
        float facing = max(dot(n, toEye), 0.0);
        vec3 hot = mix(shining.rgb, vec3(1.0), 0.16 * facing * facing);
        writeRadiance(radianceOf(mix(shining.rgb * 0.1, hot * (0.8 + 0.35 * facing), shining.a) + flash));
    } else {
        Material material = materialAt(materialIndex);
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
        s.anchorPosition = eyeFromAnchor + LIGHT_SHARE * relativePosition;
#endif
#ifdef SKY_AMBIENT
        s.skyVisibility = dot(n * n, mix(skySeenBehind, skySeenAhead, step(0.0, n)));
#endif
        vec2 light = gunLight(inGun, own);
        vec3 glow = (0.15 + s.baseColour) * (lamp * light.x + flash * light.y);
        float aside = 1.0 - max(dot(n, toEye), 0.0);
        glow += s.baseColour * (FILL * (1.0 + 0.5 * n.y)) + OUTLINE * aside * aside * aside;
        writeRadiance(surfaceRadiance(s) + radianceOf(glow));
    }
#ifdef EXPOSURE_METERED
    pixel.a = 0.0; // the hand before the eye is no part of the metered picture
#endif
}
