// A corner of an opening, placed by render.resource.OpeningMesh: the same depth as in the opening's depth pass.
#include "frame.glsl"

layout(location = 0) in vec4 clipPosition;

invariant gl_Position;

void main() {
    gl_Position = shifted(clipPosition);
}
