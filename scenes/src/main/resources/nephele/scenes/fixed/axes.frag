flat in vec3 axisColour;

out vec4 colour;

void main() {
    colour = vec4(axisColour, 1.0);
}
