// A corner of an opening, placed by render.resource.OpeningMesh.
#include "frame.glsl"

layout(location = 0) in vec4 clipPosition;
layout(location = 1) in vec3 lookUp;

out vec3 picturePosition; // homogeneous, in the picture that covers the opening

invariant gl_Position;

void main() {
    picturePosition = lookUp;
    gl_Position = shifted(clipPosition);
}
