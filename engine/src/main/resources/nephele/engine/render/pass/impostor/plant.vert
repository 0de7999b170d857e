// A plant near the eye: its mesh.
#include "frame.glsl"
#include "view-clip.glsl"
#include "plants.glsl"
#include "plant-fade.glsl"

layout(location = 0) in vec3 position; // metres from the foot
layout(location = 1) in vec4 normalAndSky; // 32767 for 1
layout(location = 2) in vec2 textureCoordinates;

uniform vec3 eyeHigh; // from the anchor
uniform vec3 eyeLow;
uniform float pixelsPerRadian;
#ifdef BOUNCED_LIGHT
uniform samplerBuffer bouncedLight; // a texel a plant
flat out vec3 bounced;
#endif

out vec3 relativePosition;
out vec3 normal;
out float skyShare;
#ifdef TEXTURED
out vec2 st;
#endif
flat out vec2 plantLook; // x: radius, metres, y: the mesh's share
flat out vec3 emission;

void main() {
    Plant plant = plantAt(plantNumber(gl_InstanceID));
    PlantKind kind = plantKindAt(plant.kind);
    vec3 foot = (plant.foot - eyeHigh) - eyeLow;
    float metres = length(foot + plant.scale * turned(kind.centre, plant.turn));
    float radius = kind.radius * plant.scale;
    plantLook = vec2(radius, plantMeshShare(2.0 * radius * pixelsPerRadian / metres));
    relativePosition = foot + plant.scale * turned(position, plant.turn);
    normal = turned(normalAndSky.xyz / 32767.0, plant.turn);
    skyShare = plant.sky * normalAndSky.w / 32767.0;
    emission = kind.emission;
#ifdef BOUNCED_LIGHT
    bounced = texelFetch(bouncedLight, plantNumber(gl_InstanceID)).rgb;
#endif
#ifdef TEXTURED
    st = textureCoordinates;
#endif
    clipToView(relativePosition);
    gl_Position = clipFromRelative * vec4(relativePosition, 1.0);
}
