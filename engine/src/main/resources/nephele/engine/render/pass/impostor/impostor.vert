// A plant as a rectangle that faces the eye of its view.
#include "frame.glsl"
#include "view-clip.glsl"
#ifdef FOG
#include "fog.glsl"
#endif
#ifdef AIR
#include "air.glsl"
#endif
#include "plants.glsl"
#include "impostor-views.glsl"
#include "plant-fade.glsl"

layout(location = 0) in vec2 corner; // -1 or 1

uniform vec3 eyeHigh; // from the anchor
uniform vec3 eyeLow;
uniform float pixelsPerRadian;
#ifdef BOUNCED_LIGHT
uniform samplerBuffer bouncedLight; // a texel a plant
flat out vec3 bounced;
#endif

out vec3 relativePosition;
flat out vec3 towardsEye;
flat out vec4 plantLook; // x: radius, metres, y: the mesh's share, z: share of the sky, w: mipmap level
flat out vec2 plantTurn;
flat out vec4 skyFit;
flat out vec3 fromCentreToEye; // of the view
flat out vec3 emission;
flat out vec3 addedRadiance;
flat out float passing;
#ifdef AIR
flat out vec3 airPassing;
#endif
#ifndef MULTISAMPLED
out vec2 onRectangle;
flat out vec4 noiseCells;
#endif

void main() {
    int number = plantNumber(gl_InstanceID * PER_SHEET + gl_VertexID / 4);
    if (number < 0) {
        gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
        return;
    }
    Plant plant = plantAt(number);
    PlantKind kind = plantKindAt(plant.kind);
    vec3 relative = (plant.foot - eyeHigh) - eyeLow + plant.scale * turned(kind.centre, plant.turn);
    float metres = length(relative);
    vec3 toEye = relative / -metres;
    float radius = kind.radius * plant.scale;
    vec2 outline = plantOutline(kind, toEye) * plant.scale;
    // What is nearer than the middle looks larger.
    vec2 shown = outline * (1.0 + radius / metres);
    vec3 right = plantRight(toEye);
    vec3 fromCentre = corner.x * shown.x * right + corner.y * shown.y * cross(toEye, right);
    float diameter = 2.0 * radius * pixelsPerRadian / metres;
    float widening = plantWidening(diameter, plant.rank);
    if (widening <= 0.0) {
        gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
        return;
    }
    vec3 position = relative + fromCentre + (widening - 1.0) * corner.x * shown.x * right;

    atlasLayer = float(plant.kind);
    chooseViews(kind, turnedBack(toEye, plant.turn), turnedBack(fromCentre, plant.turn) / plant.scale,
        turnedBack(normalize(relative + fromCentre), plant.turn));
    vec2 pixels = 2.0 * outline * (pixelsPerRadian / metres);
    float lod = 0.5 * log2(VIEW_TEXELS * VIEW_TEXELS * FILLED * FILLED / (pixels.x * pixels.y));
    // A whole level costs half; each plant changes it at a distance of its own.
    float level = floor(lod + LOD_BIAS + plant.rank);
    plantLook = vec4(radius, plantMeshShare(diameter), plant.sky, max(level, 0.0));
#ifndef MULTISAMPLED
    onRectangle = 0.5 + 0.5 * corner;
    float noise = mix(0.9, 0.3, clamp((max(pixels.x, pixels.y) - 16.0) / 48.0, 0.0, 1.0));
    noiseCells = vec4(exp2(ceil(log2(max(pixels, 1.0)))), float(number % 4096) * 613.0, noise);
#endif
    plantTurn = plant.turn;
    skyFit = kind.sky;
    towardsEye = toEye;
    fromCentreToEye = -relative;
    emission = kind.emission;
#ifdef BOUNCED_LIGHT
    bounced = texelFetch(bouncedLight, number).rgb;
#endif
    relativePosition = position;
    addedRadiance = vec3(0.0);
    passing = 1.0;
#ifdef AIR
    Air air = airAlong(relative);
    airPassing = air.transmittance;
    addedRadiance = air.inScatter;
#endif
#ifdef FOG
    passing = throughFog(relative);
    addedRadiance = mix(fog.rgb, addedRadiance, passing);
#endif
    clipToView(position);
    gl_Position = clipFromRelative * vec4(position, 1.0);
}
