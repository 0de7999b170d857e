layout(location = 0) in vec3 position; // clip space, w = 1
layout(location = 1) in vec4 colourAndAlpha;
layout(location = 2) in vec2 acrossAndHalf; // pixels from the axis, half the width

flat out vec4 lineColour;
flat out float halfWidth;
out float across;

void main() {
    lineColour = colourAndAlpha;
    halfWidth = acrossAndHalf.y;
    across = acrossAndHalf.x;
    gl_Position = vec4(position, 1.0);
}
