layout(location = 0) in vec3 position; // in its cell

uniform mat4 clipFromCell;

void main() {
    gl_Position = clipFromCell * vec4(position, 1.0);
}
