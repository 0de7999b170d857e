layout(location = 0) in vec3 direction;
layout(location = 1) in vec3 colour;

uniform vec3 eye;
uniform float halfLength;
uniform mat4 clipFromRelative;

flat out vec3 axisColour;

void main() {
    axisColour = colour;
    gl_Position = clipFromRelative * vec4(halfLength * direction - eye, 1.0);
}
