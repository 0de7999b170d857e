// The light of a shot on the surfaces around the muzzle, added to their finished picture. Place and normal follow from the
// depths around the pixel; the share of light that the surface reflects is estimated from its colour in the picture.
#include "output.glsl"
#include "exposure.glsl"
#include "displayed.glsl"
#include "view-distance.glsl"
#ifdef OUTPUT_DIRECT
#include "radiance-of-pixel.glsl"
#endif

uniform sampler2D viewDepth;
uniform sampler2D viewColour;
uniform vec4 muzzle; // xyz: from the eye, metres; w: square metres that soften the light close to it
uniform vec4 intensity; // rgb: radiant, as displayed; a: 1 / range^2

const float GUN_DEPTH = 0.05; // window depths before it are the gun's, which has a light of its own: = gun.vert, DEPTH_SHARE

const float DARK_SHARE = java(scene.MuzzleLight.DARK_SHARE);
const float FAR = 1e4; // metres, in place of the sky's distance

vec3 placeAt(ivec2 at, float depth) {
    vec2 corner = 2.0 * (vec2(at) + 0.5) / vec2(textureSize(viewDepth, 0)) - 1.0;
    vec3 direction = shownDirection(corner);
    return min(axisMetres(depth), FAR) / dot(direction, viewForward.xyz) * direction;
}

// Returns the way along the surface to the next pixel, towards the side whose depth differs less: the other one may lie
// beyond an edge.
vec3 tangentAt(ivec2 at, float depth, vec3 place, ivec2 step) {
    ivec2 last = textureSize(viewDepth, 0) - 1;
    ivec2 before = max(at - step, ivec2(0));
    ivec2 after = min(at + step, last);
    float depthBefore = texelFetch(viewDepth, before, 0).r;
    float depthAfter = texelFetch(viewDepth, after, 0).r;
    bool isAfter = before == at || (after != at && abs(depthAfter - depth) < abs(depthBefore - depth));
    return isAfter ? placeAt(after, depthAfter) - place : place - placeAt(before, depthBefore);
}

// The brighter a surface looks, the more it reflects, but one in shade reflects more than it looks. Of a dark one the hue is
// unknown.
vec3 reflectedShare(vec3 displayed) {
    float most = max(max(displayed.r, displayed.g), displayed.b);
    vec3 hue = (displayed + 0.01) / (most + 0.01);
    return mix(vec3(1.0), hue, 0.6) * (DARK_SHARE + 0.45 * sqrt(min(most, 1.0)));
}

void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    float depth = texelFetch(viewDepth, at, 0).r;
    vec3 place = placeAt(at, depth);
    vec3 towards = muzzle.xyz - place;
    float square = dot(towards, towards);
    float q = square * intensity.a;
    if (depth <= GUN_DEPTH || depth >= 1.0 || q >= 1.0) {
        discard;
    }
    vec3 normal = cross(tangentAt(at, depth, place, ivec2(1, 0)), tangentAt(at, depth, place, ivec2(0, 1)));
    normal *= dot(normal, place) > 0.0 ? -1.0 : 1.0;
    float facing = dot(normal, towards) * inversesqrt(max(dot(normal, normal) * square, 1e-20));
    float window = 1.0 - q * q;
    vec3 stored = texelFetch(viewColour, at, 0).rgb;
#ifdef OUTPUT_DIRECT
    vec3 before = radianceOfPixel(stored);
#else
    vec3 before = stored;
#endif
    vec3 displayed = before * exposureFactor();
    vec3 added = radianceOf(reflectedShare(displayed) * intensity.rgb)
            * (max(facing, 0.0) * window * window / (square + muzzle.w));
#ifdef FOG
    added *= throughFog(place);
#endif
#ifdef MIRRORS
    added *= mirrorTint.rgb;
#endif
#ifdef OUTPUT_DIRECT
    pixel = vec4(max(encodeSrgb(toneCurve((before + added) * exposureFactor())) - stored, 0.0), 1.0);
#else
    float most = max(max(added.r, added.g), added.b);
    pixel = vec4(added, most / max(most + max(max(before.r, before.g), before.b), 1e-6));
#endif
}
