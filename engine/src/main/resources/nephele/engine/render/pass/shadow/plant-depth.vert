// A plant's mesh as the sun sees it.
#include "plants.glsl"

layout(location = 0) in vec3 position; // metres from the foot

uniform mat4 clipFromAnchor;

void main() {
    Plant plant = plantAt(plantNumber(gl_InstanceID));
    gl_Position = clipFromAnchor * vec4(plant.foot + plant.scale * turned(position, plant.turn), 1.0);
}
