// Adds the light of exits' curtains between the eye and the surface behind them; with VEILS it dims instead what is
// behind the gaps between their strands. The ray's two ways through a shell are each integrated at the two points of
// Gauss and Legendre.
//
// Light for output DIRECT replaces the pixel by a sum, so that sum has every exit's; otherwise one exit is drawn.
#include "output.glsl"
#include "displayed.glsl"
#include "view-distance.glsl"
#include "exits.glsl"
#include "exit-curtain.glsl"
#if defined(OUTPUT_DIRECT) && !defined(VEILS)
#include "radiance-of-pixel.glsl"
uniform sampler2D viewColour;
#else
uniform int drawnExit;
#endif

in vec3 relativePosition;

uniform float seconds;
uniform sampler2D viewDepth;

// Returns the light of a part of the ray, in multiples of its direction, within one shell.
vec3 lightOfPart(vec2 part, vec3 direction, int exit) {
    if (part.y <= part.x) {
        return vec3(0.0);
    }
    float unit = length(direction);
    vec3 light = vec3(0.0);
    for (int i = 0; i < 2; i++) {
        float place = mix(part.x, part.y, i == 0 ? 0.2113249 : 0.7886751);
        vec3 fromFeet = place * direction - feetAndRadius[exit].xyz;
        vec2 size = vec2(feetAndRadius[exit].w, heightMetres[exit]);
#ifdef VEILS
        vec3 emission = vec3(curtainVeil(fromFeet, size, seconds));
#else
        vec3 emission = curtainEmission(fromFeet, size, seconds);
#endif
#ifdef FOG
        emission *= throughFog(place * direction);
#endif
        light += emission;
    }
#ifdef AIR
    light *= airAlong(0.5 * (part.x + part.y) * direction).transmittance;
#endif
    return 0.5 * (part.y - part.x) * unit * light;
}

// visible: the part of the ray in front of the surface
vec3 lightOf(int exit, vec3 direction, vec2 visible) {
    vec4 at = feetAndRadius[exit];
    float flatUnit = max(length(direction.xz), 1e-6 * length(direction));
    vec2 heading = direction.xz / flatUnit;
    float along = dot(heading, at.xz);
    float beside = heading.x * at.z - heading.y * at.x;
    float inner = (1.0 - SHELL_SHARE) * at.w;
    float halfOuter = sqrt(max(at.w * at.w - beside * beside, 0.0));
    float halfInner = sqrt(max(inner * inner - beside * beside, 0.0));
    vec2 inside = overlapOf(visible, withinSlab(-at.y, direction.y, heightMetres[exit]));
    vec2 before = vec2(along - halfOuter, along - halfInner) / flatUnit;
    vec2 after = vec2(along + halfInner, along + halfOuter) / flatUnit;
    return lightOfPart(overlapOf(before, inside), direction, exit) + lightOfPart(overlapOf(after, inside), direction, exit);
}

void main() {
    vec3 direction = relativePosition;
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec2 visible = vec2(0.0, axisMetres(texelFetch(viewDepth, at, 0).r) / dot(direction, viewForward.xyz));
#ifdef PORTALS
    float towardsClip = dot(viewClip.xyz, direction);
    if (towardsClip > 0.0) {
        visible.x = max(visible.x, -viewClip.w / towardsClip);
    }
#endif
    vec3 light = vec3(0.0);
#if defined(OUTPUT_DIRECT) && !defined(VEILS)
    for (int exit = 0; exit < EXITS; exit++) {
        light += lightOf(exit, direction, visible);
    }
#else
    light = lightOf(drawnExit, direction, visible);
#endif
    if (light.r <= 0.0) {
        discard;
    }
#ifdef VEILS
    float passing = exp(-light.g);
#ifdef OUTPUT_DIRECT
    passing = pow(passing, 1.0 / 2.2); // of a value that is encoded already
    pixel = vec4(pow(VEIL_COLOUR, vec3(1.0 / 2.2)), 1.0 - passing);
#else
    pixel = vec4(radianceOf(VEIL_COLOUR), 1.0 - passing);
#endif
#else
    vec3 radiance = radianceOf(light);
#ifdef MIRRORS
    radiance *= mirrorTint.rgb;
#endif
#ifdef OUTPUT_DIRECT
    vec4 stored = texelFetch(viewColour, at, 0);
    pixel = vec4(toneMapped(radianceOfPixel(stored.rgb) + radiance, exposureFactor()), 1.0);
#ifdef DISTANCE_STORED
    pixel.a = stored.a;
#endif
#else
    pixel = vec4(radiance, 1.0);
#endif
#endif
}
