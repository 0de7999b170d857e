// A plant as the sun sees it, from its atlas.
#include "plants.glsl"
#include "impostor-views.glsl"

layout(location = 0) in vec2 corner; // -1 or 1

uniform mat4 clipFromAnchor;
uniform vec3 towardsSun; // unit

flat out float depthPerRadius;

void main() {
    int number = plantNumber(gl_InstanceID * PER_SHEET + gl_VertexID / 4);
    if (number < 0) {
        gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
        return;
    }
    Plant plant = plantAt(number);
    PlantKind kind = plantKindAt(plant.kind);
    vec3 right = plantRight(towardsSun);
    vec2 outline = plantOutline(kind, towardsSun) * plant.scale;
    vec3 fromCentre = corner.x * outline.x * right + corner.y * outline.y * cross(towardsSun, right);
    vec3 toSun = turnedBack(towardsSun, plant.turn);
    atlasLayer = float(plant.kind);
    chooseViews(kind, toSun, turnedBack(fromCentre, plant.turn) / plant.scale, -toSun);
    vec3 radius = kind.radius * plant.scale * towardsSun;
    depthPerRadius = 0.5 * (mat3(clipFromAnchor) * radius).z;
    gl_Position = clipFromAnchor * vec4(plant.foot + plant.scale * turned(kind.centre, plant.turn) + fromCentre, 1.0);
}
