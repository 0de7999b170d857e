flat in vec4 lineColour;
flat in float halfWidth;
in float across;

out vec4 colour;

void main() {
    float coverage = clamp(halfWidth + 0.5 - abs(across), 0.0, 1.0);
    colour = vec4(lineColour.rgb, lineColour.a * coverage);
}
