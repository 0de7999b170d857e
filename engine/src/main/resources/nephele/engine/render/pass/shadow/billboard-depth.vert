// A billboard as it faces the sun, or the level's observer, without the swing of its sway.
#include "shadow-filter.glsl"
#include "billboard.glsl"

uniform mat4 clipFromAnchor;
#ifdef OBSERVER
uniform vec3 observer; // from the anchor
#else
uniform vec3 towardsSun; // unit
uniform vec3 mapRight; // unit
#endif

out vec2 st;
flat out float layer;
flat out uint octant;

void main() {
    int number = billboardNumber();
    if (number < 0) {
        gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
        return;
    }
    Billboard b = billboardAt(number);
    vec4 shape = billboardGroup(b.group, 0);
    vec2 size = shape.xy * b.scale;
    int facing = int(shape.z);
#ifdef OBSERVER
    BillboardAxes axes = observedAxes(facing, observer - b.foot - vec3(0.0, 0.5 * size.y, 0.0), b.turn);
#else
    facing = facing == SCREEN ? SPHERICAL : facing > CROSSED ? CYLINDRICAL : facing;
    BillboardAxes axes = facingAxes(facing, towardsSun, mapRight, vec3(0.0, 1.0, 0.0), b.turn);
#endif
    float lean = size.y * billboardGroup(b.group, 2).x;
    vec3 position = b.foot + vec3(0.0, 0.5 * size.y, 0.0) + cornerFromMiddle(axes, size, lean);
    gl_Position = clipFromAnchor * vec4(position, 1.0);
    st = vec2(0.5 + 0.5 * corner.x, 0.5 - 0.5 * corner.y);
    layer = shape.w + floor(billboardFrame(billboardGroup(b.group, 1), b));
    octant = octantOf(cross(axes.right, axes.up));
}
