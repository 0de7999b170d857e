layout(location = 0) in vec3 position; // metres from the origin of the lines

uniform mat4 clipFromRelative;
uniform vec3 originFromEye;

void main() {
    gl_Position = clipFromRelative * vec4(position + originFromEye, 1.0);
}
