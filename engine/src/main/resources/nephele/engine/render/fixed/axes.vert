layout(location = 0) in vec3 position;
layout(location = 1) in vec3 colour;

uniform vec3 eye;
uniform mat4 clipFromRelative;

flat out vec3 axisColour;

void main() {
    axisColour = colour;
    gl_Position = clipFromRelative * vec4(position - eye, 1.0);
}
