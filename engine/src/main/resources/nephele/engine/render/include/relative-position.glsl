// The position of a solid's vertex. Invariant, because the depth that the depth pass writes must match exactly.
#include "frame.glsl"
#include "view-clip.glsl"

layout(location = 0) in vec3 position; // in its cell

// The eye in the cell as two floats a component; the difference to a near vertex is exact.
uniform vec3 eyeHigh;
uniform vec3 eyeLow;

invariant gl_Position;

// Sets gl_Position; returns the vertex relative to the eye.
vec3 placeVertex() {
    vec3 relative = (position - eyeHigh) - eyeLow;
    gl_Position = clipFromRelative * vec4(relative, 1.0);
    clipToView(relative);
    return relative;
}
