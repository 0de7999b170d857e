// The rectangle of a bolt or of a shimmer.
#include "view-clip.glsl"

layout(location = 0) in vec2 corner; // -1 or 1

uniform vec3 origin; // from the eye: where a bolt begins, or a shimmer's middle
uniform vec3 along; // a bolt's whole way, or the first axis of a shimmer
uniform vec3 across; // a unit vector, or the second axis
uniform vec2 widths; // of a bolt: metres, and the least at a metre's distance; negative for a shimmer

out vec2 place;
out vec3 relativePosition;

void main() {
    vec3 relative;
    if (widths.x < 0.0) {
        relative = origin + along * corner.x + across * corner.y;
        place = corner;
    } else {
        place = vec2(0.5 * corner.x + 0.5, corner.y);
        relative = origin + along * place.x;
        relative += across * (corner.y * max(widths.x, widths.y * length(relative)));
    }
    relativePosition = relative;
    clipToView(relative);
    gl_Position = clipFromRelative * vec4(relative, 1.0);
}
